// SPDX-License-Identifier: MIT
#include "app/window/WindowActions.h"

#include <array>

#include <QtCore/QCoreApplication>

#include "app/window/MainWindow.h"
#include "widgets/viewport/SelectionCommands.h"
#include "widgets/viewport/ViewCommands.h"

namespace crowd::app {

namespace {

using widgets::ActionSpec;

struct WindowAction
{
    ActionSpec spec;
    void (*run)(MainWindow& window, bool isChecked);
};

#define ACTION_TEXT(text) QT_TRANSLATE_NOOP("Actions", text)

const WindowAction kFileActions[] = {
    {{"new-theatre", ACTION_TEXT("New &Theatre"), "new-theatre", "Ctrl+N",
      ACTION_TEXT("Start with the empty theatre")},
     [](MainWindow& w, bool) { w.files().newTheatre(); }},
    {{"new-ground", ACTION_TEXT("New &Ground"), "new", "Ctrl+Shift+N",
      ACTION_TEXT("Start with empty ground")},
     [](MainWindow& w, bool) { w.files().newGround(); }},
    {{"open", ACTION_TEXT("&Open…"), "open", "Ctrl+O", ACTION_TEXT("Open a scene")},
     [](MainWindow& w, bool) { w.files().open(); }},
    {{"save", ACTION_TEXT("&Save"), "save", "Ctrl+S", ACTION_TEXT("Save the scene")},
     [](MainWindow& w, bool) { (void)w.files().save(); }},
    {{"save-as", ACTION_TEXT("Save &As…"), "save-as", "Ctrl+Shift+S",
      ACTION_TEXT("Save the scene under another name")},
     [](MainWindow& w, bool) { (void)w.files().saveAs(); }},
    {{"collect", ACTION_TEXT("&Collect Assets"), "collect", "Ctrl+Alt+S",
      ACTION_TEXT("Save the scene with copies of all its models beside it")},
     [](MainWindow& w, bool) { (void)w.files().collectAssets(); }},
    {{"import-template", ACTION_TEXT("&Import Template…"), "import", "Ctrl+I",
      ACTION_TEXT("Bring in an animated glTF model to paint with")},
     [](MainWindow& w, bool) { w.assets().importTemplate(); }},
    {{"import-stage", ACTION_TEXT("Import Sta&ge…"), "stage", "Ctrl+Shift+I",
      ACTION_TEXT("Bring in a glTF model to stand on")},
     [](MainWindow& w, bool) { w.assets().importStage(); }},
    {{"quit", ACTION_TEXT("&Quit"), "quit", "Ctrl+Q", ACTION_TEXT("Leave Crowdbrush")},
     [](MainWindow& w, bool) { w.close(); }},
};

const WindowAction kEditActions[] = {
    {{"undo", ACTION_TEXT("&Undo"), "undo", "Ctrl+Z", ACTION_TEXT("Take the last change back")},
     [](MainWindow& w, bool) { w.document().undoStack().undo(); }},
    {{"redo", ACTION_TEXT("&Redo"), "redo", "Ctrl+Shift+Z; Ctrl+Y",
      ACTION_TEXT("Do again what was taken back")},
     [](MainWindow& w, bool) { w.document().undoStack().redo(); }},
    {{"delete", ACTION_TEXT("&Delete Selected"), "delete", "Del",
      ACTION_TEXT("Remove the selected people")},
     [](MainWindow& w, bool) { widgets::deleteSelection(w.state()); }},
    {{"select-all", ACTION_TEXT("Select &All"), "select-all", "Ctrl+A",
      ACTION_TEXT("Select everybody")},
     [](MainWindow& w, bool) { w.state().selection().selectAll(); }},
    {{"select-none", ACTION_TEXT("Select &None"), "select-none", "Ctrl+Shift+A",
      ACTION_TEXT("Select nobody")},
     [](MainWindow& w, bool) { w.state().selection().clear(); }},
    {{"select-invert", ACTION_TEXT("In&vert Selection"), "select-invert", "Ctrl+Alt+I",
      ACTION_TEXT("Select those who are not selected")},
     [](MainWindow& w, bool) { w.state().selection().invert(); }},
    {{"preferences", ACTION_TEXT("&Preferences…"), "preferences", "Ctrl+,",
      ACTION_TEXT("Theme, mouse, autosave, memory, shortcuts")},
     [](MainWindow& w, bool) { w.showPreferences(); }},
};

const WindowAction kViewActions[] = {
    {{"frame-selection", ACTION_TEXT("&Frame Selection"), "frame", "F",
      ACTION_TEXT("Show the selected people; everything when nobody is selected")},
     [](MainWindow& w, bool) { widgets::frameSelection(w.state()); }},
    {{"frame-all", ACTION_TEXT("Frame &All"), "frame-all", "Home",
      ACTION_TEXT("Show the whole scene")},
     [](MainWindow& w, bool) { widgets::frameAll(w.state()); }},
    {{"view-front", ACTION_TEXT("From the F&ront"), "view-front", "1",
      ACTION_TEXT("Look at the scene from the front")},
     [](MainWindow& w, bool) { widgets::lookFrom(w.state(), widgets::ViewDirection::Front); }},
    {{"view-side", ACTION_TEXT("From the &Side"), "view-side", "3",
      ACTION_TEXT("Look at the scene from the side")},
     [](MainWindow& w, bool) { widgets::lookFrom(w.state(), widgets::ViewDirection::Side); }},
    {{"view-top", ACTION_TEXT("From Abo&ve"), "view-top", "7",
      ACTION_TEXT("Look at the scene from above")},
     [](MainWindow& w, bool) { widgets::lookFrom(w.state(), widgets::ViewDirection::Top); }},
    {{"projection", ACTION_TEXT("&Perspective or Orthographic"), "projection", "5",
      ACTION_TEXT("Change between perspective and orthographic projection")},
     [](MainWindow& w, bool) { widgets::toggleProjection(w.state()); }},
    {{"camera-add", ACTION_TEXT("&Keep This View"), "camera-add", "Ctrl+B",
      ACTION_TEXT("Add a camera of the scene where the view is now")},
     [](MainWindow& w, bool) { (void)widgets::addCamera(w.state()); }},
    {{"seat-grid", ACTION_TEXT("Seat &Grid"), "seats", "G",
      ACTION_TEXT("Create people only on free seats"), true},
     [](MainWindow& w, bool on) { w.state().setSeatGridOn(on); }},
    {{"ground-grid", ACTION_TEXT("Gr&ound Grid"), "grid", "Ctrl+G",
      ACTION_TEXT("Show a grid of metres on the ground"), true},
     [](MainWindow& w, bool on) {
         auto options = w.state().viewOptions();
         options.showGroundGrid = on;
         w.state().setViewOptions(options);
     }},
    {{"shadows", ACTION_TEXT("S&hadows"), "shadows", "Ctrl+H",
      ACTION_TEXT("Show a soft shadow under everybody"), true},
     [](MainWindow& w, bool on) {
         auto options = w.state().viewOptions();
         options.showShadows = on;
         w.state().setViewOptions(options);
     }},
    {{"look-lit", ACTION_TEXT("&Lighting"), "look", "Ctrl+L",
      ACTION_TEXT("Light the scene; otherwise plain colours"), true},
     [](MainWindow& w, bool on) {
         auto options = w.state().viewOptions();
         options.look = on ? render::Look::Lit : render::Look::Plain;
         w.state().setViewOptions(options);
     }},
    {{"full-screen", ACTION_TEXT("F&ull Screen"), "full-screen", "F11",
      ACTION_TEXT("Fill the screen with the window"), true},
     [](MainWindow& w, bool on) { on ? w.showFullScreen() : w.showNormal(); }},
};

const WindowAction kPlayActions[] = {
    {{"play", ACTION_TEXT("&Play"), "play", "Ctrl+Space", ACTION_TEXT("Play or pause"), true},
     [](MainWindow& w, bool on) { w.state().transport().setPlaying(on); }},
    {{"rewind", ACTION_TEXT("&Rewind"), "rewind", "Ctrl+Home",
      ACTION_TEXT("Back to the start of time")},
     [](MainWindow& w, bool) { w.state().transport().rewind(); }},
};

const WindowAction kOtherActions[] = {
    {{"brush-larger", ACTION_TEXT("&Larger Brush"), "larger", "]",
      ACTION_TEXT("Make the brush larger")},
     [](MainWindow& w, bool) {
         if (const auto* brush = w.state().activeBrush()) {
             w.state().setBrush(brush->resized(brush->radiusPixels * 0.15F + 1.0F));
         }
     }},
    {{"brush-smaller", ACTION_TEXT("&Smaller Brush"), "smaller", "[",
      ACTION_TEXT("Make the brush smaller")},
     [](MainWindow& w, bool) {
         if (const auto* brush = w.state().activeBrush()) {
             w.state().setBrush(brush->resized(-brush->radiusPixels * 0.13F - 1.0F));
         }
     }},
    {{"reset-layout", ACTION_TEXT("&Reset Layout"), "reset", "Ctrl+Shift+R",
      ACTION_TEXT("Put all panels back to their places")},
     [](MainWindow& w, bool) { w.resetLayout(); }},
    {{"keys", ACTION_TEXT("&Keys and Mouse"), "help", "F1",
      ACTION_TEXT("What keys and mouse buttons do")},
     [](MainWindow& w, bool) { w.showShortcuts(); }},
    {{"about", ACTION_TEXT("&About Crowdbrush"), "about", "Shift+F1",
      ACTION_TEXT("What this is, and its version")},
     [](MainWindow& w, bool) { w.showAbout(); }},
};

constexpr const char* kFileMenu[] = {
    "new-theatre",     "new-ground",   "open", "@recent", "", "save", "save-as", "collect", "",
    "import-template", "import-stage", "",     "quit"};
constexpr const char* kEditMenu[] = {
    "undo",        "redo",          "", "delete",     "", "select-all",
    "select-none", "select-invert", "", "preferences"};
constexpr const char* kBrushMenu[] = {"select",
                                      "navigate",
                                      "",
                                      "brush-create",
                                      "brush-delete",
                                      "brush-colour",
                                      "brush-orientation",
                                      "brush-animation",
                                      "",
                                      "brush-larger",
                                      "brush-smaller",
                                      "",
                                      "seat-grid"};
constexpr const char* kViewMenu[] = {"frame-selection", "frame-all", "",           "view-front",
                                     "view-side",       "view-top",  "projection", "",
                                     "camera-add",      "@cameras",  "",           "ground-grid",
                                     "shadows",         "look-lit",  "",           "full-screen"};
constexpr const char* kPlayMenu[] = {"play", "rewind"};
constexpr const char* kWindowMenu[] = {"@docks", "", "reset-layout"};
constexpr const char* kHelpMenu[] = {"keys", "about"};

constexpr MenuSpec kMenus[] = {
    {QT_TRANSLATE_NOOP("Menus", "&File"), kFileMenu},
    {QT_TRANSLATE_NOOP("Menus", "&Edit"), kEditMenu},
    {QT_TRANSLATE_NOOP("Menus", "&Brush"), kBrushMenu},
    {QT_TRANSLATE_NOOP("Menus", "&View"), kViewMenu},
    {QT_TRANSLATE_NOOP("Menus", "&Play"), kPlayMenu},
    {QT_TRANSLATE_NOOP("Menus", "&Window"), kWindowMenu},
    {QT_TRANSLATE_NOOP("Menus", "&Help"), kHelpMenu},
};

constexpr const char* kToolBar[] = {"new-theatre",
                                    "open",
                                    "save",
                                    "",
                                    "undo",
                                    "redo",
                                    "",
                                    "select",
                                    "navigate",
                                    "brush-create",
                                    "brush-delete",
                                    "brush-colour",
                                    "brush-orientation",
                                    "brush-animation",
                                    "",
                                    "seat-grid",
                                    "ground-grid",
                                    "look-lit",
                                    "frame-all",
                                    "",
                                    "rewind",
                                    "play"};

void addTools(MainWindow& window)
{
    static constexpr const char* kTips[] = {
        ACTION_TEXT("Select people, move them, delete them"),
        ACTION_TEXT("Turn, shift and zoom the view"),
        ACTION_TEXT("Spray new people into the scene"),
        ACTION_TEXT("Spray people away"),
        ACTION_TEXT("Recolour the people under the brush"),
        ACTION_TEXT("Turn the people under the brush"),
        ACTION_TEXT("Give the people under the brush another animation"),
    };
    static const char* const kTexts[] = {
        ACTION_TEXT("&Select"),    ACTION_TEXT("&Navigate"), ACTION_TEXT("&Create"),
        ACTION_TEXT("&Delete"),    ACTION_TEXT("C&olour"),   ACTION_TEXT("O&rientation"),
        ACTION_TEXT("&Animation"),
    };
    std::size_t i = 0;
    for (const widgets::ToolInfo& info : widgets::toolTable()) {
        const widgets::ToolId id = info.id;
        window.actions().add(
            {info.stableId, kTexts[i], info.stableId, info.shortcut, kTips[i], true},
            [&window, id](bool) { window.state().setTool(id); });
        ++i;
    }
}

#undef ACTION_TEXT

void addAll(MainWindow& window, std::span<const WindowAction> actions)
{
    for (const WindowAction& action : actions) {
        const auto run = action.run;
        window.actions().add(action.spec, [&window, run](bool on) { run(window, on); });
    }
}

} // namespace

void addWindowActions(MainWindow& window)
{
    addAll(window, kFileActions);
    addAll(window, kEditActions);
    addAll(window, kViewActions);
    addAll(window, kPlayActions);
    addAll(window, kOtherActions);
    addTools(window);
}

std::span<const MenuSpec> menuTable()
{
    return kMenus;
}

std::span<const char* const> toolBarTable()
{
    return kToolBar;
}

} // namespace crowd::app

// SPDX-License-Identifier: MIT
#include "app/window/WindowActions.h"

#include <algorithm>
#include <array>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

#include "app/console/ConsoleDock.h"
#include "app/window/CameraBookmarks.h"
#include "app/window/FindByName.h"
#include "app/window/MainWindow.h"
#include "app/window/SelectActions.h"
#include "app/window/StateKeys.h"
#include "app/window/TimelineActions.h"
#include "app/window/ViewMemory.h"
#include "app/window/ViewSwitch.h"
#include "widgets/commands/RelationCommands.h"
#include "widgets/commands/SelectionCommands.h"
#include "widgets/commands/TakeCommands.h"
#include "widgets/commands/ViewCommands.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/tools/BrushTool.h"
#include "widgets/tools/PlaceHandles.h"

namespace crowd::app {

namespace {

using widgets::ActionInput;
using widgets::ViewOptions;

constexpr std::array<double, 8> kSpeeds{0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 4.0, 8.0};

/// To the next of the usual speeds.
void changeSpeed(widgets::EditorState& state, int direction)
{
    const double now = state.transport().state().speed;
    double next = now;
    for (const double speed : kSpeeds) {
        if (direction < 0 && speed < now - 1e-9) {
            next = speed;
        } else if (direction > 0 && speed > now + 1e-9) {
            next = speed;
            break;
        }
    }
    state.transport().setSpeed(next);
    state.showStatus(QCoreApplication::translate("Actions", "Speed: × %1")
                         .arg(QLocale().toString(next, 'g', 3)));
}

void resizeBrush(widgets::EditorState& state, double steps)
{
    if (const model::BrushSettings* brush = state.activeBrush()) {
        const model::BrushSettings resized = widgets::resizedBySteps(*brush, steps);
        state.setBrush(resized);
        state.showStatus(widgets::brushSizeText(resized));
    }
}

bool hasSeveralPlaces(MainWindow& window)
{
    return window.state().paths().places().size() > 1;
}

bool hasBrush(MainWindow& window)
{
    return window.state().activeBrush() != nullptr;
}

QString undoText(MainWindow& window)
{
    const QUndoStack& stack = window.document().undoStack();
    return stack.canUndo()
               ? QCoreApplication::translate("Actions", "&Undo %1").arg(stack.undoText())
               : QCoreApplication::translate("Actions", "&Undo");
}

QString redoText(MainWindow& window)
{
    const QUndoStack& stack = window.document().undoStack();
    return stack.canRedo()
               ? QCoreApplication::translate("Actions", "&Redo %1").arg(stack.redoText())
               : QCoreApplication::translate("Actions", "&Redo");
}

/// What is on screen may not show it.
void undoSaying(MainWindow& window)
{
    QUndoStack& stack = window.document().undoStack();
    const QString text = stack.undoText();
    if (const QString recalled = window.state().takeRecallInRun(); !recalled.isEmpty()) {
        window.state().showStatus(QCoreApplication::translate(
                                      "Actions", "“%1” was recalled in this run alone: Stop gives "
                                                 "the scene back. Undo once more takes back: %2")
                                      .arg(recalled, text));
        return;
    }
    const int done = window.state().undoGroups().undo();
    if (done == 1) { // none: something else was said
        window.state().showStatus(QCoreApplication::translate("Actions", "Undone: %1").arg(text));
    } else if (done > 1) {
        window.state().showStatus(
            QCoreApplication::translate("Actions", "Undone: %n short stroke(s)", nullptr, done));
    }
}

void redoSaying(MainWindow& window)
{
    QUndoStack& stack = window.document().undoStack();
    const QString text = stack.redoText();
    const int done = window.state().undoGroups().redo();
    if (done == 1) {
        window.state().showStatus(
            QCoreApplication::translate("Actions", "Done again: %1").arg(text));
    } else if (done > 1) {
        window.state().showStatus(QCoreApplication::translate(
            "Actions", "Done again: %n short stroke(s)", nullptr, done));
    }
}

const WindowAction kFileActions[] = {
    {{"new-theatre", QT_TRANSLATE_NOOP("Actions", "New &Theatre"), "new-theatre", "Ctrl+N",
      QT_TRANSLATE_NOOP("Actions", "Start with the empty theatre")},
     [](MainWindow& w, bool) { w.files().newTheatre(); }},
    {{"new-ground", QT_TRANSLATE_NOOP("Actions", "New &Ground"), "new", "Ctrl+Shift+N",
      QT_TRANSLATE_NOOP("Actions", "Start with empty ground")},
     [](MainWindow& w, bool) { w.files().newGround(); }},
    {{"open", QT_TRANSLATE_NOOP("Actions", "&Open…"), "open", "Ctrl+O",
      QT_TRANSLATE_NOOP("Actions", "Open a scene")},
     [](MainWindow& w, bool) { w.files().open(); }},
    {{"save", QT_TRANSLATE_NOOP("Actions", "&Save"), "save", "Ctrl+S",
      QT_TRANSLATE_NOOP("Actions", "Save the scene")},
     [](MainWindow& w, bool) { (void)w.files().save(); }},
    {{"save-as", QT_TRANSLATE_NOOP("Actions", "Save &As…"), "save-as", "Ctrl+Shift+S",
      QT_TRANSLATE_NOOP("Actions", "Save the scene under another name")},
     [](MainWindow& w, bool) { (void)w.files().saveAs(); }},
    {{"collect", QT_TRANSLATE_NOOP("Actions", "&Collect Assets"), "collect", "Ctrl+Alt+S",
      QT_TRANSLATE_NOOP("Actions", "Save the scene with copies of all its models beside it")},
     [](MainWindow& w, bool) { (void)w.files().collectAssets(); }},
    {{"save-picture", QT_TRANSLATE_NOOP("Actions", "Save &Picture…"), "picture", "Ctrl+Shift+E",
      QT_TRANSLATE_NOOP("Actions", "Save the view as a picture, in any size")},
     [](MainWindow& w, bool) { w.savePicture(); }},
    {{"make-movie", QT_TRANSLATE_NOOP("Actions", "Make Mo&vie…"), "movie", "Ctrl+Alt+M",
      QT_TRANSLATE_NOOP("Actions", "Write what has been played, or the scene, as a movie")},
     [](MainWindow& w, bool) { w.makeMovie(); }},
    {{"library", QT_TRANSLATE_NOOP("Actions", "Add from &Library…"), "add", "Ctrl+Alt+L",
      QT_TRANSLATE_NOOP("Actions", "Choose built-in characters to paint with")},
     [](MainWindow& w, bool) { w.assets().addFromLibrary(); }},
    {{"import-template", QT_TRANSLATE_NOOP("Actions", "&Import Templates…"), "import", "Ctrl+I",
      QT_TRANSLATE_NOOP("Actions", "Bring in an animated glTF model to paint with")},
     [](MainWindow& w, bool) { w.assets().importTemplate(); }},
    {{"import-stage", QT_TRANSLATE_NOOP("Actions", "I&mport Stage…"), "stage", "Ctrl+Shift+I",
      QT_TRANSLATE_NOOP("Actions", "Bring in a glTF model to stand on")},
     [](MainWindow& w, bool) { w.assets().importStage(); }},
    {{"quit", QT_TRANSLATE_NOOP("Actions", "&Quit"), "quit", "Ctrl+Q",
      QT_TRANSLATE_NOOP("Actions", "Leave Crowdbrush")},
     [](MainWindow& w, bool) { w.close(); }},
};

const WindowAction kEditActions[] = {
    {{"undo", QT_TRANSLATE_NOOP("Actions", "&Undo"), "undo", "Ctrl+Z",
      QT_TRANSLATE_NOOP("Actions", "Take the last change back")},
     [](MainWindow& w, bool) { undoSaying(w); },
     {.inputs = ActionInput::History,
      .isEnabled = [](MainWindow& w) { return w.document().undoStack().canUndo(); },
      .text = undoText}},
    {{"redo", QT_TRANSLATE_NOOP("Actions", "&Redo"), "redo", "Ctrl+Shift+Z; Ctrl+Y",
      QT_TRANSLATE_NOOP("Actions", "Do again what was taken back")},
     [](MainWindow& w, bool) { redoSaying(w); },
     {.inputs = ActionInput::History,
      .isEnabled = [](MainWindow& w) { return w.document().undoStack().canRedo(); },
      .text = redoText}},
    {{"duplicate", QT_TRANSLATE_NOOP("Actions", "D&uplicate Selected"), "copy", "Ctrl+D",
      QT_TRANSLATE_NOOP("Actions", "Copy the selected characters beside themselves, with the "
                                   "relations among them")},
     [](MainWindow& w, bool) { widgets::duplicateSelection(w.state()); },
     {.inputs = ActionInput::Selection,
      .isEnabled = [](MainWindow& w) { return !w.state().selection().isEmpty(); }}},
    {{"delete", QT_TRANSLATE_NOOP("Actions", "&Delete Selected"), "delete", "Del; Backspace",
      QT_TRANSLATE_NOOP("Actions", "Remove the selected characters")},
     [](MainWindow& w, bool) { widgets::deleteSelection(w.state()); },
     {.inputs = ActionInput::Selection | ActionInput::Paths,
      .isEnabled =
          [](MainWindow& w) {
              return !w.state().selection().isEmpty() || !w.state().paths().places().empty();
          }}},
    {{"put-on-ground", QT_TRANSLATE_NOOP("Actions", "Put on the &Ground"), "put-on-ground", "",
      QT_TRANSLATE_NOOP("Actions",
                        "Put those of the selected characters, or of all, who stand where "
                        "nobody can walk on the nearest ground")},
     [](MainWindow& w, bool) { widgets::putSelectionOnGround(w.state()); }},
    {{"path-of-places", QT_TRANSLATE_NOOP("Actions", "Path That &Ends at the Last Place"),
      "brush-path", "Ctrl+Shift+P",
      QT_TRANSLATE_NOOP("Actions",
                        "A path over the selected places, in order; characters stop there")},
     [](MainWindow& w, bool) { widgets::makePathOfPlaces(w.state(), model::PathKind::Simple); },
     {.inputs = ActionInput::Paths, .isEnabled = hasSeveralPlaces}},
    {{"path-round-places", QT_TRANSLATE_NOOP("Actions", "Path Going &Round and Round"),
      "brush-path", "Ctrl+Alt+P",
      QT_TRANSLATE_NOOP("Actions", "A path over the selected places, and on to the first one")},
     [](MainWindow& w, bool) { widgets::makePathOfPlaces(w.state(), model::PathKind::Cyclic); },
     {.inputs = ActionInput::Paths, .isEnabled = hasSeveralPlaces}},
    {{"path-jump-places", QT_TRANSLATE_NOOP("Actions", "Path &Jumping to the First Place"),
      "brush-path", "Ctrl+Alt+Shift+P",
      QT_TRANSLATE_NOOP("Actions", "A path over the selected places; characters jump from its last "
                                   "place to its first")},
     [](MainWindow& w, bool) { widgets::makePathOfPlaces(w.state(), model::PathKind::Teleport); },
     {.inputs = ActionInput::Paths, .isEnabled = hasSeveralPlaces}},
    {{"path-end", QT_TRANSLATE_NOOP("Actions", "&End Path"), "path-end", "Return; Enter",
      QT_TRANSLATE_NOOP("Actions", "End the path, line or area that is being drawn")},
     [](MainWindow& w, bool) { widgets::endPath(w.state()); },
     {.inputs = ActionInput::Paths,
      .isEnabled =
          [](MainWindow& w) {
              const widgets::PathFocus& paths = w.state().paths();
              return paths.isPainting() || paths.shaped() != 0;
          }}},
    {{"preferences", QT_TRANSLATE_NOOP("Actions", "&Preferences…"), "preferences", "Ctrl+,",
      QT_TRANSLATE_NOOP("Actions", "Theme, mouse, autosave, memory, language, shortcuts")},
     [](MainWindow& w, bool) { w.showPreferences(); }},
};

const WindowAction kViewActions[] = {
    {{"frame-selection", QT_TRANSLATE_NOOP("Actions", "&Frame Selection"), "frame", "F",
      QT_TRANSLATE_NOOP(
          "Actions",
          "Show the selected characters and places; everything when nothing is selected")},
     [](MainWindow& w, bool) { widgets::frameSelection(w.state()); }},
    {{"frame-all", QT_TRANSLATE_NOOP("Actions", "Frame &All"), "frame-all", "Home",
      QT_TRANSLATE_NOOP("Actions", "Show the whole scene")},
     [](MainWindow& w, bool) { widgets::frameAll(w.state()); }},
    {{"view-front", QT_TRANSLATE_NOOP("Actions", "From the F&ront"), "view-front", "Num+1; Alt+1",
      QT_TRANSLATE_NOOP("Actions", "Look at the scene from the front")},
     [](MainWindow& w, bool) { widgets::lookFrom(w.state(), widgets::ViewDirection::Front); }},
    {{"view-side", QT_TRANSLATE_NOOP("Actions", "From the &Side"), "view-side", "Num+3; Alt+3",
      QT_TRANSLATE_NOOP("Actions", "Look at the scene from the side")},
     [](MainWindow& w, bool) { widgets::lookFrom(w.state(), widgets::ViewDirection::Side); }},
    {{"view-top", QT_TRANSLATE_NOOP("Actions", "From Abo&ve"), "view-top", "Num+7; Alt+7",
      QT_TRANSLATE_NOOP("Actions", "Look at the scene from above")},
     [](MainWindow& w, bool) { widgets::lookFrom(w.state(), widgets::ViewDirection::Top); }},
    {{"projection", QT_TRANSLATE_NOOP("Actions", "&Perspective or Orthographic"), "projection",
      "Num+5; Alt+5",
      QT_TRANSLATE_NOOP("Actions", "Change between perspective and orthographic projection")},
     [](MainWindow& w, bool) { widgets::toggleProjection(w.state()); }},
    {{"camera-add", QT_TRANSLATE_NOOP("Actions", "&Keep This View"), "camera-add", "Ctrl+B",
      QT_TRANSLATE_NOOP("Actions", "Add a camera of the scene where the view is now")},
     [](MainWindow& w, bool) { (void)widgets::addCamera(w.state()); }},
    {{"seat-grid", QT_TRANSLATE_NOOP("Actions", "Seat &Grid"), "seats", "G",
      QT_TRANSLATE_NOOP("Actions", "Create characters only on free seats"), true},
     [](MainWindow& w, bool on) { w.state().setSeatGridOn(on); },
     {.inputs = ActionInput::Brush,
      .isChecked = [](MainWindow& w) { return w.state().isSeatGridOn(); }}},
    viewSwitch<&ViewOptions::showGroundGrid>(
        {"ground-grid", QT_TRANSLATE_NOOP("Actions", "Gr&ound Grid"), "grid", "Ctrl+G",
         QT_TRANSLATE_NOOP("Actions", "Show a grid of metres on the ground"), true}),
    viewSwitch<&ViewOptions::showShadows>(
        {"shadows", QT_TRANSLATE_NOOP("Actions", "Sha&dows"), "shadows", "Ctrl+H",
         QT_TRANSLATE_NOOP("Actions", "Show the shadows of people and stages"), true}),
    viewSwitch<&ViewOptions::showPaths>(
        {"paths", QT_TRANSLATE_NOOP("Actions", "Pat&hs"), "brush-path", "Ctrl+Shift+H",
         QT_TRANSLATE_NOOP("Actions", "Show places and paths"), true}),
    viewSwitch<&ViewOptions::showTags>(
        {"tags", QT_TRANSLATE_NOOP("Actions", "Ta&gs"), "brush-tag", "Ctrl+Shift+T",
         QT_TRANSLATE_NOOP("Actions", "Show who has which tag by a coloured disc"), true}),
    viewSwitch<&ViewOptions::showRelations>(
        {"relations", QT_TRANSLATE_NOOP("Actions", "&Relations"), "brush-relation", "Ctrl+Shift+L",
         QT_TRANSLATE_NOOP("Actions", "Show by arcs to whom the selected are related; all of them "
                                      "where nobody is selected"),
         true}),
    viewSwitch<&ViewOptions::showWalkable>(
        {"walkable", QT_TRANSLATE_NOOP("Actions", "&Walkable Ground"), "brush-walk", "Ctrl+Shift+W",
         QT_TRANSLATE_NOOP("Actions", "Show where characters can walk by a colour on the ground"),
         true}),
    {{"look-lit", QT_TRANSLATE_NOOP("Actions", "&Lighting"), "look", "Ctrl+L",
      QT_TRANSLATE_NOOP("Actions", "Light the scene; otherwise plain colours"), true},
     [](MainWindow& w, bool on) {
         auto options = w.state().viewOptions();
         options.look = on ? render::Look::Lit : render::Look::Plain;
         options.ownLook = 0;
         w.state().setViewOptions(options);
     },
     {.inputs = ActionInput::View,
      .isChecked =
          [](MainWindow& w) { return render::lookInfo(w.state().viewOptions().look).isLit; }}},
    {{"full-screen", QT_TRANSLATE_NOOP("Actions", "F&ull Screen"), "full-screen", "F11",
      QT_TRANSLATE_NOOP("Actions", "Fill the screen with the window"), true},
     [](MainWindow& w, bool on) {
         w.setWindowState(on ? w.windowState() | Qt::WindowFullScreen
                             : w.windowState() & ~Qt::WindowFullScreen);
     },
     {.inputs = ActionInput::Window, .isChecked = [](MainWindow& w) { return w.isFullScreen(); }}},
    {{"hide-panels", QT_TRANSLATE_NOOP("Actions", "Picture &Only"), "dock", "Tab",
      QT_TRANSLATE_NOOP("Actions", "Hide panels and tool bar, or show them again"), true},
     [](MainWindow& w, bool on) { w.dockLayout().setHidden(on); },
     {.inputs = ActionInput::Window,
      .isChecked = [](MainWindow& w) { return w.dockLayout().isHidden(); }}},
};

const WindowAction kPlayActions[] = {
    {{"play", QT_TRANSLATE_NOOP("Actions", "&Play"), "play", "Ctrl+Space",
      QT_TRANSLATE_NOOP("Actions", "Play or pause"), true},
     [](MainWindow& w, bool on) { w.state().transport().setPlaying(on); },
     {.inputs = ActionInput::Playback,
      .isChecked = [](MainWindow& w) { return w.state().transport().isPlaying(); }}},
    {{"step", QT_TRANSLATE_NOOP("Actions", "&Step"), "step", "Ctrl+Right",
      QT_TRANSLATE_NOOP("Actions", "One step, then pause")},
     [](MainWindow& w, bool) { w.state().session().stepOnce(); }},
    {{"step-back", QT_TRANSLATE_NOOP("Actions", "Step &Back"), "step-back", "Ctrl+Left",
      QT_TRANSLATE_NOOP("Actions", "Everybody as they were one step before, then pause")},
     [](MainWindow& w, bool) { w.state().session().stepBack(); }},
    {{"catch-up", QT_TRANSLATE_NOOP("Actions", "&Latest Moment"), "catch-up", "Ctrl+End",
      QT_TRANSLATE_NOOP("Actions", "From an earlier moment back to where the run has come")},
     [](MainWindow& w, bool) { w.state().session().catchUp(); }},
    {{"take-from-here", QT_TRANSLATE_NOOP("Actions", "Take It from &Here"), "take-from-here",
      "Ctrl+Alt+H",
      QT_TRANSLATE_NOOP(
          "Actions",
          "The run goes on from the moment shown, and what came after it is forgotten; out of a "
          "take another run goes on from there")},
     [](MainWindow& w, bool) { w.state().session().takeFromHere(); },
     {.inputs = ActionInput::Session | ActionInput::Playback,
      .isEnabled = [](MainWindow& w) { return w.state().session().canTakeFromHere(); }}},
    {{"stop", QT_TRANSLATE_NOOP("Actions", "S&top"), "stop", "Ctrl+Home",
      QT_TRANSLATE_NOOP("Actions", "Back to the start, everybody where the scene has them")},
     [](MainWindow& w, bool) { w.state().session().stop(); }},
    {{"faster", QT_TRANSLATE_NOOP("Actions", "&Faster"), "faster", "Ctrl+Up",
      QT_TRANSLATE_NOOP("Actions", "Play faster, up to 8 times")},
     [](MainWindow& w, bool) { changeSpeed(w.state(), 1); }},
    {{"slower", QT_TRANSLATE_NOOP("Actions", "S&lower"), "slower", "Ctrl+Down",
      QT_TRANSLATE_NOOP("Actions", "Play slower, down to a tenth")},
     [](MainWindow& w, bool) { changeSpeed(w.state(), -1); }},
    {{"keep-pose", QT_TRANSLATE_NOOP("Actions", "&Keep Pose"), "keep-pose", "Ctrl+Return",
      QT_TRANSLATE_NOOP("Actions", "Put everybody in the scene where they are now")},
     [](MainWindow& w, bool) { w.state().session().keepPose(); },
     {.inputs = ActionInput::Session,
      .isEnabled = [](MainWindow& w) { return w.state().session().isPosed(); }}},
    {{"keep-take", QT_TRANSLATE_NOOP("Actions", "Keep Ta&ke"), "take-add", "Ctrl+Shift+Return",
      QT_TRANSLATE_NOOP("Actions", "Keep what has been played, to be shown again as it was")},
     [](MainWindow& w, bool) { widgets::keepTake(w.state()); }},
    {{"retake", QT_TRANSLATE_NOOP("Actions", "R&etake Selected"), "retake", "Ctrl+Alt+J",
      QT_TRANSLATE_NOOP("Actions", "In a take, they do something else in the play range, or from "
                                   "the moment shown on; everybody else does what he did")},
     [](MainWindow& w, bool) { widgets::retakeSelected(w.state()); }},
    {{"next-take", QT_TRANSLATE_NOOP("Actions", "Show Ne&xt Take"), "takes", "Ctrl+Alt+N",
      QT_TRANSLATE_NOOP("Actions", "One take after the other, then the scene as it plays")},
     [](MainWindow& w, bool) { widgets::showNextTake(w.state()); }},
};

template<DockId id>
void showDock(MainWindow& w, bool on)
{
    QDockWidget* dock = w.dockLayout().dock(id);
    dock->setVisible(on);
    dock->raise();
}

template<DockId id>
bool isDockShown(MainWindow& w)
{
    return !w.dockLayout().dock(id)->isHidden();
}

const WindowAction kPanelActions[] = {
    {{"rules", QT_TRANSLATE_NOOP("Actions", "&Rules and Cues"), "rules", "Ctrl+Shift+B",
      QT_TRANSLATE_NOOP("Actions", "Show the panel of what characters do when, and of its cues"),
      true},
     &showDock<DockId::Rules>,
     {.inputs = ActionInput::Window, .isChecked = &isDockShown<DockId::Rules>}},
    {{"timeline", QT_TRANSLATE_NOOP("Actions", "Time&line"), "timeline", "Ctrl+Shift+M",
      QT_TRANSLATE_NOOP("Actions", "Show the panel of what happens when while it plays"), true},
     &showDock<DockId::Timeline>,
     {.inputs = ActionInput::Window, .isChecked = &isDockShown<DockId::Timeline>}},
    {{"takes", QT_TRANSLATE_NOOP("Actions", "Ta&kes"), "takes", "Ctrl+Shift+K",
      QT_TRANSLATE_NOOP("Actions", "Runs that were kept: show, compare, take parts again"), true},
     &showDock<DockId::Takes>,
     {.inputs = ActionInput::Window, .isChecked = &isDockShown<DockId::Takes>}},
};

const WindowAction kScriptActions[] = {
    {{"console", QT_TRANSLATE_NOOP("Actions", "Python &Console"), "console", "F12",
      QT_TRANSLATE_NOOP("Actions", "Type Python, with the open scene as \"scene\"")},
     [](MainWindow& w, bool) { w.console().reveal(); }},
    {{"script-run", QT_TRANSLATE_NOOP("Actions", "&Run Script…"), "script-run", "Ctrl+R",
      QT_TRANSLATE_NOOP("Actions", "Run a Python file on the open scene")},
     [](MainWindow& w, bool) { w.console().runScript(); }},
    {{"script-record", QT_TRANSLATE_NOOP("Actions", "R&ecord Script"), "record", "Ctrl+Alt+R",
      QT_TRANSLATE_NOOP("Actions", "Write down as Python what is done by hand from now on"), true},
     [](MainWindow& w, bool on) { w.console().setRecording(on); },
     {.inputs = ActionInput::Recording,
      .isChecked = [](MainWindow& w) { return w.recorder().isRecording(); }}},
    {{"script-cancel", QT_TRANSLATE_NOOP("Actions", "&Stop Script"), "script-cancel", "Ctrl+.",
      QT_TRANSLATE_NOOP("Actions", "Stop the script that runs")},
     [](MainWindow& w, bool) { w.interpreter().cancel(); },
     {.inputs = ActionInput::Script,
      .isEnabled = [](MainWindow& w) { return w.interpreter().isRunning(); }}},
};

const WindowAction kOtherActions[] = {
    {{"brush-larger", QT_TRANSLATE_NOOP("Actions", "&Larger Brush"), "larger", "]",
      QT_TRANSLATE_NOOP("Actions", "Make the brush larger")},
     [](MainWindow& w, bool) { resizeBrush(w.state(), 1.0); },
     {.inputs = ActionInput::Tool, .isEnabled = hasBrush}},
    {{"brush-smaller", QT_TRANSLATE_NOOP("Actions", "S&maller Brush"), "smaller", "[",
      QT_TRANSLATE_NOOP("Actions", "Make the brush smaller")},
     [](MainWindow& w, bool) { resizeBrush(w.state(), -1.0); },
     {.inputs = ActionInput::Tool, .isEnabled = hasBrush}},
    {{"brush-reset", QT_TRANSLATE_NOOP("Actions", "Reset &Brushes"), "reset", "Ctrl+Alt+B",
      QT_TRANSLATE_NOOP("Actions", "Set all brushes as they were in the beginning")},
     [](MainWindow& w, bool) { w.brushes().reset(); }},
    {{"reset-layout", QT_TRANSLATE_NOOP("Actions", "&Reset Layout"), "reset", "Ctrl+Shift+R",
      QT_TRANSLATE_NOOP("Actions", "Put all panels back, and show in the picture "
                                   "what was shown at first")},
     [](MainWindow& w, bool) {
         w.dockLayout().reset();
         resetView(w.state());
     }},
    {{"welcome", QT_TRANSLATE_NOOP("Actions", "&Welcome Page"), "crowdbrush", "Ctrl+F1",
      QT_TRANSLATE_NOOP("Actions", "Ready-made scenes, new scenes, and what was open before")},
     [](MainWindow& w, bool) { w.showWelcome(); }},
    {{"find", QT_TRANSLATE_NOOP("Actions", "&Find…"), "locate", "Ctrl+F",
      QT_TRANSLATE_NOOP("Actions", "Type the name of an action, a brush, a panel or a setting")},
     [](MainWindow& w, bool) { findByName(w); }},
    {{"keys", QT_TRANSLATE_NOOP("Actions", "&Quick Reference Card"), "help", "F1",
      QT_TRANSLATE_NOOP("Actions", "What mouse buttons and keys do")},
     [](MainWindow& w, bool) { w.showShortcuts(); }},
    {{"about", QT_TRANSLATE_NOOP("Actions", "&About Crowdbrush"), "about", "Alt+Shift+F1",
      QT_TRANSLATE_NOOP("Actions", "What this is, and its version")},
     [](MainWindow& w, bool) { w.showAbout(); }},
};

constexpr const char* kFileMenu[] = {
    "new-theatre", "new-ground",      "open",         "@recent",    "@examples", "",
    "save",        "save-as",         "save-picture", "make-movie", "collect",   "",
    "library",     "import-template", "import-stage", "",           "quit"};
constexpr const char* kEditMenu[] = {
    "undo",     "redo", "",        "duplicate",    "delete", "put-on-ground", "@path-of-places",
    "path-end", "",     "@states", "@keep-states", "",       "@language",     "preferences"};
constexpr const char* kSelectMenu[] = {
    "select-all",    "select-none",   "select-invert",  "", "select-similar",
    "select-grow",   "select-shrink", "select-related", "", "select-lasso",
    "group-selected"};
constexpr const char* kViewMenu[] = {"frame-selection",
                                     "frame-all",
                                     "",
                                     "view-front",
                                     "view-side",
                                     "view-top",
                                     "projection",
                                     "",
                                     "camera-add",
                                     "@cameras",
                                     "@keep-cameras",
                                     "camera-follow",
                                     "",
                                     "paths",
                                     "walkable",
                                     "tags",
                                     "relations",
                                     "ground-grid",
                                     "shadows",
                                     "look-lit",
                                     "@looks",
                                     "",
                                     "full-screen"};
constexpr const char* kPlayMenu[] = {"play",
                                     "step",
                                     "step-back",
                                     "catch-up",
                                     "take-from-here",
                                     "stop",
                                     "",
                                     "faster",
                                     "slower",
                                     "@step-length",
                                     "",
                                     "keep-pose",
                                     "keep-take",
                                     "retake",
                                     "next-take",
                                     "",
                                     "timeline-record",
                                     "mark-add",
                                     "camera-mark",
                                     "mark-back",
                                     "mark-next",
                                     "",
                                     "range-begin",
                                     "range-end",
                                     "range-all",
                                     "play-loop",
                                     "",
                                     "range-first",
                                     "range-last",
                                     "",
                                     "rules",
                                     "timeline",
                                     "takes"};
constexpr const char* kScriptMenu[] = {"console", "",           "script-record",
                                       "",        "script-run", "script-cancel"};
constexpr const char* kWindowMenu[] = {"@docks", "", "hide-panels", "reset-layout"};
constexpr const char* kHelpMenu[] = {"find", "", "welcome", "keys", "about"};

constexpr const char* kBrushMenu[] = {"select",
                                      "navigate",
                                      "",
                                      "@brushes-crowd",
                                      "@brushes-look",
                                      "@brushes-motion",
                                      "@brushes-way",
                                      "@brushes-mind",
                                      "@brushes-any",
                                      "",
                                      "brush-larger",
                                      "brush-smaller",
                                      "brush-reset",
                                      "",
                                      "seat-grid"};
constexpr const char* kPathsOfPlaces[] = {"path-of-places", "path-round-places",
                                          "path-jump-places"};

std::vector<const char*> brushesOf(model::BrushSection section)
{
    std::vector<const char*> ids;
    for (const model::BrushKind kind : model::shownBrushes()) {
        if (model::brushType(kind).info.section == section) {
            ids.push_back(widgets::toolInfo(widgets::toolOf(kind)).stableId);
        }
    }
    return ids;
}

/// By section.
const std::vector<std::vector<const char*>>& brushLists()
{
    static const std::vector<std::vector<const char*>> kLists = [] {
        std::vector<std::vector<const char*>> lists;
        lists.reserve(model::kBrushSectionCount);
        for (int i = 0; i < model::kBrushSectionCount; ++i) {
            lists.push_back(brushesOf(static_cast<model::BrushSection>(i)));
        }
        return lists;
    }();
    return kLists;
}

const std::vector<SubmenuSpec>& submenus()
{
    static const std::vector<SubmenuSpec> kAll{
        {"@recent", QT_TRANSLATE_NOOP("Menus", "Open &Recent"), {}},
        {"@examples", QT_TRANSLATE_NOOP("Menus", "Open &Example"), {}},
        {"@cameras", QT_TRANSLATE_NOOP("Menus", "Go to &Camera"), {}},
        {"@keep-cameras", QT_TRANSLATE_NOOP("Menus", "Keep View as Ca&mera"), {}},
        {"@states", QT_TRANSLATE_NOOP("Menus", "Recall &State"), {}},
        {"@keep-states", QT_TRANSLATE_NOOP("Menus", "&Keep State"), {}},
        {"@path-of-places", QT_TRANSLATE_NOOP("Menus", "&Make Path of Places"), kPathsOfPlaces},
        {"@looks", QT_TRANSLATE_NOOP("Menus", "Dra&wn As"), {}},
        {"@language", QT_TRANSLATE_NOOP("Menus", "&Language"), {}},
        {"@step-length", QT_TRANSLATE_NOOP("Menus", "Len&gth of a Step"), {}},
        {"@brushes-crowd", QT_TRANSLATE_NOOP("Menus", "&Crowd"), brushLists()[0]},
        {"@brushes-look", QT_TRANSLATE_NOOP("Menus", "&Appearance"), brushLists()[1]},
        {"@brushes-motion", QT_TRANSLATE_NOOP("Menus", "&Motion"), brushLists()[2]},
        {"@brushes-way", QT_TRANSLATE_NOOP("Menus", "&Ways and Places"), brushLists()[3]},
        {"@brushes-mind", QT_TRANSLATE_NOOP("Menus", "&Behaviour and Groups"), brushLists()[4]},
        {"@brushes-any", QT_TRANSLATE_NOOP("Menus", "&Values and Scripts"), brushLists()[5]},
    };
    return kAll;
}

constexpr const char* kToolBar[] = {
    "new-theatre", "open",        "save",     "",          "undo",    "redo", "",
    "seat-grid",   "ground-grid", "look-lit", "frame-all", "",        "stop", "play",
    "step",        "keep-pose",   "",         "rules",     "timeline"};

struct ToolAction
{
    widgets::ToolId id;
    widgets::ActionSpec spec;
};

ToolAction toolAction(widgets::ToolId id, const char* text, const char* tip)
{
    const widgets::ToolInfo& info = widgets::toolInfo(id);
    return {id, {info.stableId, text, info.stableId, info.shortcut, tip, true}};
}

std::vector<ToolAction> toolActions()
{
    std::vector<ToolAction> tools{
        toolAction(widgets::ToolId::Select, QT_TRANSLATE_NOOP("Actions", "&Select"),
                   QT_TRANSLATE_NOOP("Actions", "Select characters, move them, delete them")),
        toolAction(widgets::ToolId::Navigate, QT_TRANSLATE_NOOP("Actions", "&Navigate"),
                   QT_TRANSLATE_NOOP("Actions", "Turn, shift and zoom the view"))};
    for (const model::BrushKind kind : model::shownBrushes()) {
        const model::BrushInfo& info = model::brushType(kind).info;
        tools.push_back(toolAction(widgets::toolOf(kind), info.menu, info.tip));
    }
    return tools;
}

void addTools(MainWindow& window)
{
    for (const ToolAction& tool : toolActions()) {
        window.actions().add(tool.spec,
                             [&window, id = tool.id](bool) { window.state().setTool(id); },
                             {.inputs = ActionInput::Tool, .isChecked = [&window, id = tool.id] {
                                  return window.state().tool() == id;
                              }});
    }
}

/// In the order in which they are added.
std::array<std::span<const WindowAction>, 9> actionTables()
{
    return {kFileActions,      kEditActions,  selectActions(), kViewActions, kPlayActions,
            timelineActions(), kPanelActions, kScriptActions,  kOtherActions};
}

/// Of one that asks the window, one that asks this window.
template<class Value>
std::function<Value()> bound(MainWindow& window, Value (*ask)(MainWindow&))
{
    return ask == nullptr ? std::function<Value()>() : [&window, ask] { return ask(window); };
}

void addAll(MainWindow& window, std::span<const WindowAction> actions)
{
    for (const WindowAction& action : actions) {
        const auto run = action.run;
        const WindowState& state = action.state;
        window.actions().add(action.spec, [&window, run](bool on) { run(window, on); },
                             {state.inputs, bound(window, state.isEnabled),
                              bound(window, state.isChecked), bound(window, state.text)});
    }
}

/// The one place that says which signal changes which input.
void connectInputs(MainWindow& window)
{
    widgets::ActionRegistry& actions = window.actions();
    const auto follow = [&actions](const auto* sender, auto signal, ActionInput input) {
        QObject::connect(sender, signal, &actions, [&actions, input] { actions.refresh(input); });
    };
    widgets::EditorState& state = window.state();
    follow(&window.document().undoStack(), &QUndoStack::indexChanged, ActionInput::History);
    follow(&state.selection(), &widgets::Selection::changed, ActionInput::Selection);
    follow(&state.paths(), &widgets::PathFocus::changed, ActionInput::Paths);
    follow(&state, &widgets::EditorState::toolChanged, ActionInput::Tool);
    follow(&state, &widgets::EditorState::brushChanged, ActionInput::Brush);
    follow(&state, &widgets::EditorState::viewOptionsChanged, ActionInput::View);
    follow(&state.director(), &widgets::CameraDirector::changed, ActionInput::View);
    follow(&state.transport(), &widgets::Transport::stateChanged, ActionInput::Playback);
    follow(&state.session(), &widgets::SessionControl::stateChanged, ActionInput::Session);
    follow(&state.session().recorder(), &widgets::MarkRecorder::changed, ActionInput::Session);
    follow(&window.interpreter(), &Interpreter::started, ActionInput::Script);
    follow(&window.interpreter(), &Interpreter::finished, ActionInput::Script);
    follow(&window.recorder(), &Recorder::recordingChanged, ActionInput::Recording);
    follow(&window.dockLayout(), &DockLayout::hiddenChanged, ActionInput::Window);
}

} // namespace

void addWindowActions(MainWindow& window)
{
    for (const std::span<const WindowAction> table : actionTables()) {
        addAll(window, table);
    }
    addTools(window);
    connectInputs(window);
}

void addActionsAlone(widgets::ActionRegistry& actions)
{
    const auto nothing = [](bool) {};
    for (const std::span<const WindowAction> table : actionTables()) {
        for (const WindowAction& action : table) {
            actions.add(action.spec, nothing);
        }
    }
    for (const ToolAction& tool : toolActions()) {
        actions.add(tool.spec, nothing);
    }
    for (const NumberedKeys* keys : {&cameraKeyTable(), &stateKeyTable()}) {
        for (const NumberedKey& key : *keys) {
            actions.add({key.go, key.goText, "", key.goKeys, ""}, nothing);
            actions.add({key.keep, key.keepText, "", key.keepKeys, ""}, nothing);
        }
    }
}

std::span<const MenuSpec> menuTable()
{
    static const MenuSpec kMenus[] = {
        {QT_TRANSLATE_NOOP("Menus", "&File"), kFileMenu},
        {QT_TRANSLATE_NOOP("Menus", "&Edit"), kEditMenu},
        {QT_TRANSLATE_NOOP("Menus", "&Select"), kSelectMenu},
        {QT_TRANSLATE_NOOP("Menus", "&Brush"), kBrushMenu},
        {QT_TRANSLATE_NOOP("Menus", "&View"), kViewMenu},
        {QT_TRANSLATE_NOOP("Menus", "&Play"), kPlayMenu},
        {QT_TRANSLATE_NOOP("Menus", "&Script"), kScriptMenu},
        {QT_TRANSLATE_NOOP("Menus", "&Window"), kWindowMenu},
        {QT_TRANSLATE_NOOP("Menus", "&Help"), kHelpMenu},
    };
    return kMenus;
}

const SubmenuSpec& submenuSpec(std::string_view id)
{
    return *std::ranges::find(submenus(), id, &SubmenuSpec::id);
}

std::span<const char* const> toolBarTable()
{
    return kToolBar;
}

} // namespace crowd::app

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// What a kind of brush says of itself, once: palettes, menus, tool bars, keys, forms, scripts,
/// recordings, history and the manual follow from it and from the fields of its settings.
namespace crowd::model {

struct BrushSettings;

/// What a stroke works on.
enum class StrokeFamily : std::uint8_t {
    People,   ///< individuals that are selected and changed, told or removed
    Creation, ///< spots of the ground or seats, where people come
    Places    ///< spots of the ground, where places come: no stroke of the document
};

/// What Ctrl+click takes from under the cursor for the brush, besides what the settings' take()
/// takes from a person.
enum class Dropper : std::uint8_t { None, Colour, Point };

/// What a brush is for, in the order of palette and menus.
enum class BrushSection : std::uint8_t { Crowd, Look, Motion, Way, Mind, Any };
inline constexpr int kBrushSectionCount = 6;

/// A control of the form that stands after the fields.
enum class OperatorPlace : std::uint8_t {
    None,
    First,
    Last,
    CurveOnly ///< how often drawn values come; the operators are fields of the brush
};

/// Texts are literals: `name` in the translation context "Tools"; `menu` and `tip` in "Actions";
/// `hint` and `done` in "BrushTool"; `undo` and `unchanged` in "Brushes"; `note`, `cornersNote` and
/// `gradientNote` in "Fields". `done` and `undo` count (%n).
struct BrushInfo
{
    const char* id;       ///< stable, lower case: "scale" is action brush-scale, icons/brush-scale
    const char* name;     ///< on screen
    const char* menu;     ///< the same, short and with a mnemonic
    const char* tip;      ///< of the menu and the tool bar
    const char* shortcut; ///< default key, portable text
    int order = 0;        ///< in its section of palette and menus, ascending
    BrushSection section = BrushSection::Any;
    StrokeFamily family = StrokeFamily::People;

    const char* scriptKind = "";  ///< member of crowdbrush.BrushKind; empty: no strokes in scripts
    const char* scriptName = "";  ///< attribute of crowdbrush.Brush with the settings; empty: they
                                  ///< are attributes of the brush itself
    const char* scriptClass = ""; ///< name of the settings' class in scripts
    const char* doc = "";         ///< of that class

    const char* hint = "";        ///< what drags and keys do
    const char* done = "";        ///< after a stroke: "%n characters scaled"
    const char* undo = "";        ///< in the history: "Scale %n character(s)"
    const char* unchanged = "";   ///< why a stroke did nothing although somebody was meant
    const char* note = "";        ///< at the end of the form
    const char* cornersNote = ""; ///< in its stead where shapes with corners are drawn

    OperatorPlace operatorPlace = OperatorPlace::None;
    const char* gradientNote = ""; ///< what the gradient operator does
    bool buildsUp = false;         ///< dabs may change again whom they touch
    bool flows = false;            ///< and go a share of the way
    bool isTogether = false;       ///< changes all whom the stroke has touched together, anew with
                                   ///< each that comes
    bool movesPeople = false;      ///< dabs find people where those before have put them
    Dropper dropper = Dropper::None;
};

/// The number that + and - change. Label and format are literals in the context "BrushTexts";
/// values are as shown.
struct MainNumber
{
    const char* label;  ///< "Strength, %"
    const char* format; ///< "Strength: %1 %"
    double value;
    double low;
    double high;
    double step;
    int decimals;
    bool isCyclic = false; ///< beyond one end it goes on at the other
};

} // namespace crowd::model

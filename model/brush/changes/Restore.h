// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;

/// What people get back of theirs.
enum class RestoreSource : std::uint8_t { Template, Created, Saved, Before, State };

inline constexpr FieldChoice kRestoreSources[] = {
    {"TEMPLATE", QT_TRANSLATE_NOOP("Fields", "What their template has")},
    {"CREATED", QT_TRANSLATE_NOOP("Fields", "As they were created")},
    {"SAVED", QT_TRANSLATE_NOOP("Fields", "As last saved")},
    {"BEFORE", QT_TRANSLATE_NOOP("Fields", "As before the last brush")},
    {"STATE", QT_TRANSLATE_NOOP("Fields", "What a state has of them")}};

/// Gives people back what their template has, or what they had earlier, see EarlierPeople; who was
/// not there then, or was of another template, stays as he is. Or what a kept state has of them,
/// see recallState().
struct RestoreSettings
{
    RestoreSource source = RestoreSource::Template;
    std::uint32_t state = 0; ///< StateId; of State
    bool isWhole = true;     ///< of State: all that it holds, else what is ticked
    bool colours = true;     ///< of the template: no tints
    bool materials = true;   ///< of the template: the first of each slot
    bool parts = true;       ///< of the template: those that are shown by default
    bool size = false;       ///< of the template: 1
    bool clips = false;      ///< of the template: what suits standing or sitting, at speed 1

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static bool isOfState(const RestoreSettings& restore, const FieldContext& /*context*/)
    {
        return restore.source == RestoreSource::State;
    }
    static bool isTicked(const RestoreSettings& restore, const FieldContext& /*context*/)
    {
        return restore.source != RestoreSource::State || !restore.isWhole;
    }
    static void prepare(BrushSettings& brush);
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const RestoreSettings&, const RestoreSettings&) = default;
};

inline constexpr BrushInfo RestoreSettings::kInfo{
    .id = "restore",
    .name = QT_TRANSLATE_NOOP("Tools", "Restore Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Restore"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Give the characters under the brush back what they had"),
    .shortcut = "Shift+R",
    .order = 40,
    .section = BrushSection::Any,
    .scriptKind = "RESTORE",
    .scriptName = "restore",
    .scriptClass = "RestoreSettings",
    .doc = "What people get back.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: give back what they had"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters restored"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Restore %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them are like that already")};

constexpr auto RestoreSettings::fields()
{
    using S = RestoreSettings;
    return std::tuple(
        field(&S::source,
              {.key = "source",
               .label = QT_TRANSLATE_NOOP("Fields", "Source"),
               .tip = QT_TRANSLATE_NOOP(
                   "Fields", "As they were created: those of a file as they were when it was "
                             "opened. As before the last brush: before the brush was taken up "
                             "that was used before this one."),
               .doc = "Where it comes from.",
               .choices = kRestoreSources,
               .section = QT_TRANSLATE_NOOP("Fields", "Restore")}),
        field(&S::state, {.key = "state",
                          .label = QT_TRANSLATE_NOOP("Fields", "State"),
                          .doc = "The id of a state; of STATE.",
                          .high = 4294967295.0,
                          .role = FieldRole::State,
                          .isRemembered = false,
                          .zero = QT_TRANSLATE_NOOP("Fields", "none")})
            .when(&isOfState),
        field(&S::isWhole, {.key = "whole",
                            .label = QT_TRANSLATE_NOOP("Fields", "All that it holds"),
                            .doc = "All that the state holds, else what is ticked; of STATE."})
            .when(&isOfState),
        field(&S::colours, {.key = "colours", .label = QT_TRANSLATE_NOOP("Fields", "Colours")})
            .when(&isTicked),
        field(&S::materials,
              {.key = "materials", .label = QT_TRANSLATE_NOOP("Fields", "Materials")})
            .when(&isTicked),
        field(&S::parts, {.key = "parts", .label = QT_TRANSLATE_NOOP("Fields", "Parts")})
            .when(&isTicked),
        field(&S::size, {.key = "size", .label = QT_TRANSLATE_NOOP("Fields", "Size")})
            .when(&isTicked),
        field(&S::clips, {.key = "clips",
                          .label = QT_TRANSLATE_NOOP("Fields", "Clips"),
                          .tip = QT_TRANSLATE_NOOP(
                              "Fields", "From the template: what suits standing or sitting, at the "
                                        "usual speed")})
            .when(&isTicked));
}

} // namespace crowd::model

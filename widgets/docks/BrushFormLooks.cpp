// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "widgets/docks/BrushFormParts.h"

namespace crowd::widgets {

namespace {

using model::BrushSettings;
using model::ValueRange;

constexpr int kWholes = 2; ///< choices before the slots' names: clothes, all

/// Names of all slots of the scene's templates, each once.
std::vector<std::string> slotNames(const model::Scene& scene)
{
    std::vector<std::string> names;
    std::set<std::string> known;
    for (const model::TemplateEntry& entry : scene.templates) {
        for (std::size_t i = 0; entry.asset && i < entry.asset->slots.size(); ++i) {
            if (known.insert(entry.asset->slots[i].name).second) {
                names.push_back(entry.asset->slots[i].name);
            }
        }
    }
    return names;
}

} // namespace

void addColour(BrushForm& form, const EditorState& state)
{
    const std::vector<std::string> names = slotNames(state.scene());
    QStringList texts{BrushForm::tr("Clothes"), BrushForm::tr("All tintable")};
    for (const std::string& name : names) {
        texts << QString::fromStdString(name);
    }
    form.beginSection(BrushForm::tr("Paint"), QStringLiteral("paint"));
    form.addChoice(
        BrushForm::tr("Slot"), texts,
        [names](const BrushSettings& s) {
            const auto found = std::ranges::find(names, s.colour.slot);
            const int whole = s.colour.sparesBody ? 0 : 1;
            return found == names.end() ? whole : static_cast<int>(found - names.begin()) + kWholes;
        },
        [names](BrushSettings& s, int i) {
            s.colour.sparesBody = i == 0;
            s.colour.slot =
                i < kWholes ? std::string() : names[static_cast<std::size_t>(i - kWholes)];
        });
    form.addChoice(
        BrushForm::tr("Mode"), {BrushForm::tr("Multiply"), BrushForm::tr("Replace")},
        [](const BrushSettings& s) { return s.colour.replaces ? 1 : 0; },
        [](BrushSettings& s, int i) { s.colour.replaces = i == 1; });
    addFloat(form, BrushForm::tr("Strength"), kPercent, 100.0,
             [](BrushSettings& s) -> float& { return s.colour.strength; });
    addFlag(
        form, BrushForm::tr("Blend the colours"),
        BrushForm::tr("Also what lies between the colours, not only one of them"),
        [](BrushSettings& s) -> bool& { return s.colour.blends; }, isRandom);
    addFlag(
        form, BrushForm::tr("Each slot its own"),
        BrushForm::tr("Another colour for each slot of a character"),
        [](BrushSettings& s) -> bool& { return s.colour.eachSlotApart; }, isRandom);
}

void addAnimation(BrushForm& form)
{
    form.beginSection(BrushForm::tr("Clips (none: as they are)"), QStringLiteral("clips"));
    form.addClips([](BrushSettings & s) -> auto& { return s.animation.clips; });
    form.beginSection(BrushForm::tr("Timing"), QStringLiteral("timing"));
    addFlag(form, BrushForm::tr("Change the phase"), {},
            [](BrushSettings& s) -> bool& { return s.animation.setsPhase; });
    form.addRange(
        BrushForm::tr("Phase"), {0.0, 1.0, 0.05, 2, {}, false},
        [](BrushSettings& s) -> ValueRange& { return s.animation.phase; },
        [](const BrushSettings& s) { return s.animation.setsPhase; });
    addFlag(form, BrushForm::tr("Change the speed"), {},
            [](BrushSettings& s) -> bool& { return s.animation.setsSpeed; });
    form.addRange(
        BrushForm::tr("Speed"), {0.0, 4.0, 0.05, 2, {}, false},
        [](BrushSettings& s) -> ValueRange& { return s.animation.speed; },
        [](const BrushSettings& s) { return s.animation.setsSpeed; });
}

} // namespace crowd::widgets

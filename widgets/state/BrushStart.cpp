// SPDX-License-Identifier: MIT
#include "widgets/state/BrushStart.h"

#include <algorithm>
#include <set>
#include <utility>

#include <QtCore/QCoreApplication>

#include "model/brush/ClipChoice.h"
#include "model/brush/FeatureBrush.h"
#include "model/states/StateKeeping.h"

namespace crowd::widgets {

using model::BrushKind;
using model::BrushSettings;

namespace {

struct BrushStartText
{
    Q_DECLARE_TR_FUNCTIONS(BrushStart)
};

/// Templates of the people, of all that are loaded where there is nobody.
std::vector<const model::TemplateEntry*> entriesInUse(const model::Scene& scene)
{
    const auto column = scene.population.column(model::columns::templateId);
    const std::set<model::TemplateId> used(column.begin(), column.end());
    std::vector<const model::TemplateEntry*> entries;
    for (const model::TemplateEntry& entry : scene.templates) {
        if (entry.asset && (used.empty() || used.contains(entry.id))) {
            entries.push_back(&entry);
        }
    }
    return entries;
}

/// What goes on for ever on the spot.
bool staysInPlace(const model::TemplateEntry& entry, std::size_t column)
{
    const int clip = entry.asset->clipIndex(entry.clipNames[column]);
    return clip >= 0 && entry.asset->clips[static_cast<std::size_t>(clip)].loop &&
           !model::movesOverGround(entry, column, static_cast<std::size_t>(clip));
}

bool hasAnyTemplate(const model::Scene& scene, const model::TemplateSettings& settings)
{
    return std::ranges::any_of(settings.templates, [&scene](int id) {
        return scene.findTemplate(static_cast<model::TemplateId>(id)) != nullptr;
    });
}

bool hasAnyClip(const model::Scene& scene, const model::AnimationSettings& settings)
{
    return std::ranges::any_of(settings.clips, [&scene](const model::ClipWeight& clip) {
        return std::ranges::any_of(scene.templates, [&clip](const model::TemplateEntry& entry) {
            return std::ranges::find(entry.clipNames, clip.clip) != entry.clipNames.end();
        });
    });
}

void chooseTemplates(const EditorState& state, BrushSettings& brush)
{
    std::vector<int>& chosen = brush.as<model::TemplateSettings>().templates;
    chosen.clear();
    for (const model::TemplateWeight& item :
         state.brush(BrushKind::Create).as<model::CreateSettings>().mix) {
        if (item.weight > 0.0F) {
            chosen.push_back(static_cast<int>(item.id));
        }
    }
}

void chooseClips(const EditorState& state, BrushSettings& brush)
{
    std::vector<model::ClipWeight>& clips = brush.as<model::AnimationSettings>().clips;
    clips.clear();
    for (const model::TemplateEntry* entry : entriesInUse(state.scene())) {
        for (std::size_t i = 0; i < entry->clipNames.size(); ++i) {
            const std::string& name = entry->clipNames[i];
            if (staysInPlace(*entry, i) &&
                std::ranges::find(clips, name, &model::ClipWeight::clip) == clips.end()) {
                clips.push_back({name, 1.0F});
            }
        }
    }
}

/// Of all parts, where everybody wears all that he has.
void chooseWhetherPartsShow(const EditorState& state, BrushSettings& brush)
{
    auto& settings = brush.as<model::PartsSettings>();
    const model::Scene& scene = state.scene();
    const auto parts = scene.population.column(model::columns::parts);
    const auto templates = scene.population.column(model::columns::templateId);
    for (std::size_t row = 0; row < parts.size(); ++row) {
        const model::TemplateEntry* entry = scene.findTemplate(templates[row]);
        const std::size_t count = entry != nullptr && entry->asset ? entry->asset->parts.size() : 0;
        for (std::size_t i = 0; i < count; ++i) {
            if ((parts[row] & (std::uint32_t{1} << i)) == 0) {
                return; // there is something to be shown
            }
        }
    }
    settings.isShown = false;
}

/// Whether a state holds anything of what is ticked to be given back.
bool givesBack(const model::State& state, const model::RestoreSettings& settings)
{
    using model::PropertyAspect;
    const std::pair<bool, PropertyAspect> ticked[] = {
        {settings.colours, PropertyAspect::Colours},
        {settings.materials || settings.parts, PropertyAspect::Materials},
        {settings.size, PropertyAspect::Size},
        {settings.clips, PropertyAspect::Animation}};
    bool isHeld = false;
    for (const auto& [isTicked, aspect] : ticked) {
        if (isTicked) {
            model::columnsOf(aspect).forEach(
                [&](model::ColumnId column) { isHeld |= state.columns.contains(column); });
        }
    }
    return isHeld;
}

/// Who has kept states means them, where there is something of theirs to give back: one that holds
/// only what people do has no colour for those who were painted.
void chooseRestored(const EditorState& state, model::RestoreSettings& settings)
{
    const auto& states = state.scene().states;
    const auto find = [&states](std::uint32_t id) {
        return std::ranges::find(states, id, &model::State::id);
    };
    if (states.empty() || find(settings.state) != states.end()) {
        return;
    }
    const auto chosen = find(state.chosenState());
    const model::State& usual = chosen != states.end() ? *chosen : states.front();
    if (givesBack(usual, settings)) {
        settings.source = model::RestoreSource::State;
        settings.state = usual.id;
    }
}

/// A kind that came with another scene is not there: the usual one takes its place.
void chooseFeatureKind(const model::Scene& scene, model::FeatureSettings& settings, BrushKind kind)
{
    if (scene.features.empty() || findKind(scene.features, settings.kind) != nullptr) {
        return;
    }
    const BrushSettings usual(kind);
    const model::FeatureKind* own = findKind(scene.features, featureSettings(usual)->kind);
    settings.kind = own != nullptr ? own->name : scene.features.front().name;
    settings.values.clear();
}

} // namespace

bool startBrush(EditorState& state, BrushKind kind)
{
    BrushSettings brush = state.brush(kind);
    bool isReady = true;
    if (const auto* templates = brush.find<model::TemplateSettings>()) {
        if (!hasAnyTemplate(state.scene(), *templates)) {
            chooseTemplates(state, brush);
        }
        isReady = !templates->templates.empty();
    } else if (const auto* animation = brush.find<model::AnimationSettings>()) {
        if (!hasAnyClip(state.scene(), *animation)) {
            chooseClips(state, brush);
        }
        isReady = !animation->clips.empty();
    } else if (const auto* parts = brush.find<model::PartsSettings>()) {
        if (parts->part.empty() && parts->isShown) {
            chooseWhetherPartsShow(state, brush);
        }
    } else if (auto* restore = brush.find<model::RestoreSettings>()) {
        chooseRestored(state, *restore);
    } else if (auto* feature = featureSettings(brush)) {
        chooseFeatureKind(state.scene(), *feature, kind);
    } else if (const auto* script = brush.find<model::ScriptSettings>()) {
        if (script->brush.empty() && !state.scriptBrushes().empty()) {
            const BrushSettings first = state.scriptBrushes().front().settings;
            state.chooseScriptBrush(first.as<model::ScriptSettings>().brush);
        }
        return !state.scriptBrushes().empty();
    }
    state.setBrush(brush);
    return isReady;
}

QString missingOf(const EditorState& state, BrushKind kind)
{
    const BrushSettings& brush = state.brush(kind);
    const model::Scene& scene = state.scene();
    if (const auto* clone = brush.find<model::CloneSettings>()) {
        return scene.population.rowOf(clone->source) != model::Population::npos
                   ? QString()
                   : BrushStartText::tr("Click the character that the others are to be like");
    }
    if (const auto* group = brush.find<model::GroupSettings>();
        group != nullptr && group->group == 0) {
        return scene.groups.empty()
                   ? BrushStartText::tr("The first stroke makes a new group")
                   : BrushStartText::tr(
                         "No group is chosen: strokes take characters out of theirs");
    }
    if (kind == BrushKind::Script && state.scriptBrushes().empty()) {
        return BrushStartText::tr(
            "No script has brought a brush along yet: run one in the Python console");
    }
    const auto* restore = brush.find<model::RestoreSettings>();
    if (restore != nullptr && restore->source == model::RestoreSource::State &&
        std::ranges::find(scene.states, restore->state, &model::State::id) == scene.states.end()) {
        return BrushStartText::tr("Choose in the settings which state characters get back");
    }
    if (kind == BrushKind::Retake && state.session().take() == 0) {
        return BrushStartText::tr("No take is shown: keep what was played, then choose it in the "
                                  "Takes panel");
    }
    const auto* templates = brush.find<model::TemplateSettings>();
    if (templates != nullptr && templates->templates.empty()) {
        return BrushStartText::tr("Choose in the settings which templates characters become");
    }
    return {};
}

} // namespace crowd::widgets

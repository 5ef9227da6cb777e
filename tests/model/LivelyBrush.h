// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/scene/Path.h"
#include "tests/model/BrushScene.h"

/// A scene where every brush has something to do, and brushes set so that each does much.
namespace crowd::test {

inline constexpr TemplateId kOtherMan = 2;
inline constexpr GroupId kLivelyGroup = 1;
inline constexpr PathId kLivelyPath = 1;

/// The box man with two materials a slot and two parts; another one, whose slots and clips come in
/// another order; a group, a tag, a path. Sixty people of varied values; give them with addCrowd().
struct LivelyScene : BrushScene
{
    LivelyScene()
    {
        Scene scene;
        scene.templates.push_back(boxManEntry(1, variedMan(false)));
        scene.templates.push_back(boxManEntry(kOtherMan, variedMan(true)));
        scene.templates.back().clipNames = {"cheer", "sit", "idle"};
        scene.templates.back().name = "other man";
        Group group;
        group.id = kLivelyGroup;
        group.name = "group";
        scene.groups.push_back(group);
        scene.tags.push_back({0, "tag"});
        Path path;
        path.id = kLivelyPath;
        path.name = "path";
        scene.paths.push_back(path);
        document.replaceScene(std::move(scene), {});
    }

    static TemplatePtr variedMan(bool isOther)
    {
        auto varied = std::make_shared<Template>(*boxMan());
        varied->parts = {{"hat", true}, {"bag", false}};
        for (Slot& slot : varied->slots) {
            slot.choices.resize(2);
            slot.choices[0].name = "plain";
            slot.choices[1].name = "striped";
        }
        if (isOther) {
            varied->name = "other man";
            std::swap(varied->slots[0], varied->slots[2]);
            std::swap(varied->clips[0], varied->clips[2]);
            varied->defaultClip = 2;
        }
        return varied;
    }

    /// Half of them of each template; no two alike.
    Ids addCrowd()
    {
        const Ids ids = addPeople(crowdGrid());
        IndividualRows rows = people().rows(ids);
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const auto share = static_cast<float>(i) / static_cast<float>(ids.size());
            rows.column(columns::templateId)[i] = i % 2 == 0 ? TemplateId{1} : kOtherMan;
            rows.column(columns::height)[i] = 0.9F + 0.2F * share;
            rows.column(columns::girth)[i] = 1.1F - 0.2F * share;
            rows.column(columns::heading)[i] = 3.0F * share - 1.0F;
            rows.column(columns::phase)[i] = share;
            rows.column(columns::playbackSpeed)[i] = 0.5F + share;
            rows.column(columns::walkSpeed)[i] = 1.0F + share;
            rows.column(columns::tint(1))[i] = {static_cast<std::uint8_t>(4 * i), 10, 20, 255};
            rows.column(columns::materialChoices)[i] = {1, 1, 0};
            rows.column(columns::parts)[i] = i % 3 == 0 ? 2U : 1U;
            rows.column(columns::tags)[i] = 1;
        }
        const auto edit = document.beginEdit().value();
        for (const ColumnId column :
             {ColumnId::Template, ColumnId::Height, ColumnId::Girth, ColumnId::Heading,
              ColumnId::Phase, ColumnId::PlaybackSpeed, ColumnId::WalkSpeed, ColumnId::Tint1,
              ColumnId::MaterialChoices, ColumnId::Parts, ColumnId::Tags}) {
            edit->setColumn(column, ids, rows.bytes[static_cast<std::size_t>(column)]);
        }
        edit->commit(QStringLiteral("Vary"));
        return ids;
    }
};

/// What a kind needs besides its own defaults to do something in a LivelyScene.
inline void enliven(BrushSettings& settings)
{
    if (auto* create = settings.find<CreateSettings>()) {
        create->minimalDistance = 0.3F;
        create->palette = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
    }
    if (auto* colour = settings.find<ColourSettings>()) {
        colour->blends = true;
    }
    if (auto* turning = settings.find<OrientationSettings>()) {
        turning->heading.mode =
            settings.op == BrushOperator::Random ? HeadingMode::Random : HeadingMode::AlongStroke;
    }
    if (auto* animation = settings.find<AnimationSettings>()) {
        animation->clips = {{"sit", 1.0F}, {"cheer", 2.0F}};
        animation->setsSpeed = true;
        animation->speed = {0.5F, 2.0F};
    }
    if (auto* walk = settings.find<WalkSettings>()) {
        walk->path = kLivelyPath;
    }
    if (auto* style = settings.find<StyleSettings>()) {
        style->clips = {{"cheer", 1.0F}};
    }
    if (auto* tag = settings.find<TagSettings>()) {
        tag->tag = 2; // everybody has the first
    }
    if (auto* group = settings.find<GroupSettings>()) {
        group->group = kLivelyGroup;
    }
    if (auto* swap = settings.find<TemplateSettings>()) {
        swap->templates = {kOtherMan};
    }
    if (auto* clone = settings.find<CloneSettings>()) {
        clone->source = 31; // in the middle
        clone->heading = true;
        clone->walking = true;
    }
    if (auto* smooth = settings.find<SmoothSettings>()) {
        *smooth = {1.5F, true, true, true, true, true};
    }
    if (auto* shuffle = settings.find<ShuffleSettings>()) {
        *shuffle = {true, true, true, true, true};
    }
    if (auto* feature = settings.find<FeatureSettings>()) {
        feature->values = {{"sad", 1.0F}, {"excited", 2.0F}};
    }
    if (auto* relation = settings.find<RelationSettings>()) {
        relation->how = RelationHow::Near;
        relation->strength = {0.2F, 0.9F};
    }
    if (auto* restore = settings.find<RestoreSettings>()) {
        *restore = {RestoreSource::Template, true, true, true, true, true};
    }
}

/// A brush of a kind that changes much, with all that is random about it.
inline BrushSettings livelyBrush(BrushKind kind, BrushSelection selection, BrushOperator op)
{
    BrushSettings settings = brush(kind, selection);
    settings.op = op;
    settings.ratePerSecond = 60.0F;
    enliven(settings);
    return settings;
}

/// Brushes that make, remove or change individuals by themselves.
inline std::vector<BrushKind> paintingBrushes()
{
    std::vector<BrushKind> kinds;
    for (const BrushKind kind : shownBrushes()) {
        const bool isPainting = brushType(kind).info.family != StrokeFamily::Places &&
                                kind != BrushKind::Event && kind != BrushKind::Retake &&
                                kind != BrushKind::Script;
        if (isPainting) {
            kinds.push_back(kind);
        }
    }
    return kinds;
}

} // namespace crowd::test

// SPDX-License-Identifier: MIT
#include <initializer_list>
#include <utility>

#include <QtCore/QtGlobal>

#include "model/scene/Feature.h"

namespace crowd::model {

namespace {

struct Tempo
{
    ValueRange playback;
    ValueRange walking; ///< metres per second
};

FeatureValue emotion(FeatureId id, const char* name, const PaintColor& color,
                     std::vector<FeatureClip> clips, const Tempo& tempo)
{
    FeatureValue value;
    value.id = id;
    value.name = name;
    value.color = color;
    value.clips = std::move(clips);
    value.setsPhase = true;
    value.setsSpeed = true;
    value.speed = tempo.playback;
    value.setsWalkSpeed = true;
    value.walkSpeed = tempo.walking;
    return value;
}

/// And those to stand and sit at rest with.
std::vector<FeatureClip> restAnd(std::vector<FeatureClip> clips)
{
    clips.push_back({"", 1.0F, ClipRole::Idle});
    clips.push_back({"", 1.0F, ClipRole::Sit});
    return clips;
}

/// Names that a template does not have are passed over: there are those of the built-in cast, and
/// those that others use.
std::vector<FeatureValue> calmEmotions()
{
    return {
        emotion(1, QT_TRANSLATE_NOOP("Features", "neutral"), {150, 150, 150},
                restAnd({{"look around", 0.2F}, {"talk", 0.2F}, {"walk", 1.0F, ClipRole::Walk}}),
                {{0.9F, 1.1F}, {1.2F, 1.5F}}),
        emotion(2, QT_TRANSLATE_NOOP("Features", "sad"), {70, 100, 170},
                {{"sad", 4.0F},
                 {"cry", 2.0F},
                 {"crying", 2.0F},
                 {"defeat", 1.0F},
                 {"walk", 1.0F, ClipRole::Walk}},
                {{0.75F, 0.95F}, {0.7F, 0.95F}}),
        emotion(3, QT_TRANSLATE_NOOP("Features", "bored"), {140, 120, 160},
                {{"bored", 3.0F},
                 {"yawn", 1.0F},
                 {"look around", 0.5F},
                 {"walk", 1.0F, ClipRole::Walk}},
                {{0.7F, 0.95F}, {0.8F, 1.1F}}),
        emotion(4, QT_TRANSLATE_NOOP("Features", "attentive"), {90, 170, 160},
                restAnd({{"watch", 1.0F}, {"listen", 1.0F}, {"walk", 1.0F, ClipRole::Walk}}),
                {{0.85F, 1.0F}, {1.1F, 1.4F}}),
    };
}

std::vector<FeatureValue> livelyEmotions()
{
    return {
        emotion(5, QT_TRANSLATE_NOOP("Features", "happy"), {240, 200, 70},
                {{"clap", 3.0F},
                 {"wave", 1.0F},
                 {"talk", 1.0F},
                 {"laugh", 2.0F},
                 {"happy", 2.0F},
                 {"smile", 1.0F},
                 {"dance", 0.6F},
                 {"walk", 1.0F, ClipRole::Walk}},
                {{0.95F, 1.2F}, {1.3F, 1.6F}}),
        emotion(6, QT_TRANSLATE_NOOP("Features", "excited"), {245, 130, 50},
                {{"cheer", 4.0F},
                 {"cheering", 4.0F},
                 {"celebrate", 2.0F},
                 {"victory", 2.0F},
                 {"jump", 1.0F},
                 {"wave", 1.0F},
                 {"dance", 1.0F},
                 {"walk", 1.0F, ClipRole::Walk}},
                {{1.05F, 1.4F}, {1.6F, 2.0F}}),
        emotion(7, QT_TRANSLATE_NOOP("Features", "angry"), {210, 60, 60},
                {{"angry", 4.0F},
                 {"anger", 2.0F},
                 {"shout", 2.0F},
                 {"yell", 2.0F},
                 {"argue", 2.0F},
                 {"walk", 1.0F, ClipRole::Walk}},
                {{1.05F, 1.35F}, {1.5F, 1.9F}}),
    };
}

/// From low spirits to high ones, as a gradient runs through them.
FeatureKind emotions()
{
    FeatureKind kind;
    kind.id = 1;
    kind.name = QT_TRANSLATE_NOOP("Features", "emotion");
    kind.values = calmEmotions();
    for (FeatureValue& value : livelyEmotions()) {
        kind.values.push_back(std::move(value));
    }
    return kind;
}

/// Colours of what people wear above, below, on their feet and beside.
struct Wardrobe
{
    std::vector<PaintColor> beside;
    std::vector<PaintColor> above;
    std::vector<PaintColor> below;
    std::vector<PaintColor> shoes;
};

FeatureValue outfit(FeatureId id, const char* name, const PaintColor& color,
                    const Wardrobe& wardrobe, std::vector<FeaturePart> parts = {})
{
    FeatureValue value;
    value.id = id;
    value.name = name;
    value.color = color;
    const auto add = [&value](const std::vector<PaintColor>& colors,
                              std::initializer_list<const char*> slots) {
        for (const char* slot : slots) {
            FeatureSlot& worn = value.slots.emplace_back();
            worn.slot = slot;
            worn.colors = colors;
        }
    };
    add(wardrobe.above, {"top", "shirt", "jacket", "dress", "upper", "torso"});
    add(wardrobe.below, {"bottom", "pants", "trousers", "skirt", "jeans", "lower", "legs"});
    add(wardrobe.shoes, {"shoes", "shoe", "boots", "feet"});
    add(wardrobe.beside, {"hat", "cap", "scarf", "shawl", "cloak", "cape", "veil", "bag", "tie"});
    value.parts = std::move(parts);
    return value;
}

/// Of a team: what is seen from afar in its colour.
FeatureValue team(FeatureId id, const char* name, const PaintColor& color, const PaintColor& darker)
{
    const PaintColor white{238, 238, 238};
    return outfit(id, name, color,
                  {{color, darker}, {color}, {white, {32, 34, 40}}, {white, {24, 24, 28}}});
}

std::vector<FeatureValue> modernOutfits()
{
    const std::vector<PaintColor> dark{{22, 22, 26}, {30, 30, 40}, {38, 32, 34}};
    const std::vector<PaintColor> leather{{34, 26, 22}, {58, 40, 28}, {20, 20, 22}};
    return {
        outfit(8, QT_TRANSLATE_NOOP("Features", "everyday"), {120, 140, 160},
               {{{110, 90, 70}, {70, 80, 95}, {130, 60, 55}, {60, 95, 80}},
                {{214, 208, 196}, {90, 115, 150}, {150, 70, 60}, {84, 110, 84}, {60, 62, 70}},
                {{44, 56, 84}, {70, 72, 78}, {104, 88, 66}, {36, 36, 42}},
                {{60, 44, 34}, {210, 210, 206}, {36, 36, 40}}}),
        outfit(9, QT_TRANSLATE_NOOP("Features", "evening"), {70, 40, 80},
               {{{120, 20, 40}, {26, 26, 30}, {190, 170, 120}},
                {{24, 24, 28}, {32, 30, 44}, {96, 20, 40}, {24, 52, 58}, {62, 34, 72}},
                dark,
                {{18, 18, 20}}},
               {{"backpack", false}, {"cap", false}}),
        outfit(10, QT_TRANSLATE_NOOP("Features", "work"), {220, 140, 40},
               {{{230, 150, 40}, {60, 66, 76}},
                {{232, 138, 34}, {214, 200, 60}, {54, 84, 120}, {70, 76, 70}},
                {{44, 58, 86}, {64, 66, 70}, {86, 78, 62}},
                leather}),
        outfit(11, QT_TRANSLATE_NOOP("Features", "sport"), {60, 180, 120},
               {{{240, 240, 240}, {40, 160, 110}, {230, 80, 50}},
                {{40, 170, 120}, {240, 90, 60}, {70, 120, 230}, {250, 220, 70}, {236, 236, 236}},
                {{24, 26, 32}, {60, 64, 74}, {40, 60, 130}, {228, 228, 228}},
                {{240, 240, 240}, {240, 110, 60}, {70, 200, 220}}},
               {{"hat", false}, {"veil", false}, {"shawl", false}}),
        outfit(12, QT_TRANSLATE_NOOP("Features", "rain"), {90, 110, 130},
               {{{60, 70, 84}, {90, 84, 60}},
                {{206, 178, 60}, {70, 84, 104}, {66, 86, 70}, {120, 60, 56}, {48, 50, 58}},
                {{40, 44, 54}, {58, 56, 54}},
                {{36, 60, 50}, {30, 34, 44}, {190, 160, 50}}},
               {{"hat", true}, {"cap", true}, {"scarf", true}, {"shawl", true}}),
        team(13, QT_TRANSLATE_NOOP("Features", "team red"), {200, 34, 40}, {150, 20, 30}),
        team(14, QT_TRANSLATE_NOOP("Features", "team blue"), {36, 76, 190}, {24, 44, 130}),
    };
}

std::vector<FeatureValue> antiqueOutfits()
{
    return {
        outfit(15, QT_TRANSLATE_NOOP("Features", "antique rich"), {150, 40, 110},
               {{{122, 24, 66}, {150, 34, 40}, {226, 190, 90}, {238, 232, 220}},
                {{240, 234, 222}, {236, 226, 204}, {190, 60, 60}, {120, 40, 100}, {70, 90, 140}},
                {{236, 228, 212}, {200, 180, 140}},
                {{110, 66, 36}, {140, 92, 48}}},
               {{"fold", true}, {"veil", true}, {"shawl", true}, {"backpack", false}}),
        outfit(16, QT_TRANSLATE_NOOP("Features", "antique poor"), {140, 120, 90},
               {{{120, 104, 80}, {96, 84, 66}},
                {{168, 150, 120}, {140, 122, 94}, {118, 108, 92}, {150, 128, 104}},
                {{128, 112, 88}, {104, 92, 74}},
                {{92, 70, 48}, {74, 58, 44}}},
               {{"fold", false}, {"backpack", false}}),
    };
}

FeatureKind outfits()
{
    FeatureKind kind;
    kind.id = 2;
    kind.name = QT_TRANSLATE_NOOP("Features", "outfit");
    kind.values = modernOutfits();
    for (FeatureValue& value : antiqueOutfits()) {
        kind.values.push_back(std::move(value));
    }
    return kind;
}

} // namespace

const FeatureKinds& readyFeatures()
{
    static const FeatureKinds kReady{emotions(), outfits()};
    return kReady;
}

} // namespace crowd::model

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "model/base/Values.h"
#include "model/describe/Field.h"
#include "model/population/Columns.h"
#include "model/template/ClipRole.h"

/// Features: what people are like, in words of the artist. A value says what it does to those who
/// bear it, by names and uses, so that it serves every template that has such clips, slots and
/// parts; what it does not name stays. Plain values, part of the scene.
namespace crowd::model {

/// Clips that a value lets its bearers play, or walk with where they are gaits.
struct FeatureClip
{
    std::string clip; ///< the words of its name, as "cheer" of "sit_cheer"; empty: any of the role
    float weight = 1.0F;
    ClipRole role = ClipRole::Other; ///< Other: whatever it is for
    std::string unknownMembers{};    ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const FeatureClip&, const FeatureClip&) = default;
};

/// One of a slot's materials, by its name.
struct FeatureMaterial
{
    std::string name;
    float weight = 1.0F;
    std::string unknownMembers{}; ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const FeatureMaterial&, const FeatureMaterial&) = default;
};

/// How a slot looks. Colours and materials are drawn for each bearer; none: as they are.
struct FeatureSlot
{
    std::string slot; ///< the words of its name; empty: what is worn and no other entry names
    std::vector<PaintColor> colors; ///< sRGB, each as often as the others
    float strength = 1.0F;          ///< of the tint, 0..1
    bool replaces = true;           ///< the colour itself; else it multiplies the material's
    std::vector<FeatureMaterial> materials;
    std::string unknownMembers{}; ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const FeatureSlot&, const FeatureSlot&) = default;
};

struct FeaturePart
{
    std::string part; ///< the words of its name; empty: all
    bool isShown = true;
    std::string unknownMembers{}; ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const FeaturePart&, const FeaturePart&) = default;
};

/// "happy", "evening".
struct FeatureValue
{
    FeatureId id = 0;
    std::string name;
    PaintColor color{150, 150, 150}; ///< in which it is shown
    std::vector<int> templates;      ///< ids of those it is limited to, ascending; none: all
    std::vector<FeatureClip> clips;
    bool setsPhase = false; ///< a start of his own for each bearer
    ValueRange phase{0.0F, 1.0F};
    DistributionCurve phaseCurve;
    bool setsSpeed = false;
    ValueRange speed{1.0F, 1.0F}; ///< of playback
    DistributionCurve speedCurve;
    bool setsWalkSpeed = false;
    ValueRange walkSpeed{1.2F, 1.5F}; ///< metres per second
    DistributionCurve walkSpeedCurve;
    bool setsHeight = false;
    ValueRange height{0.95F, 1.05F};
    DistributionCurve heightCurve;
    bool setsGirth = false;
    ValueRange girth{0.95F, 1.05F};
    DistributionCurve girthCurve;
    std::vector<FeatureSlot> slots;
    std::vector<FeaturePart> parts;
    std::string unknownMembers{}; ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const FeatureValue&, const FeatureValue&) = default;
};

/// "emotion". Its id is the column that says who bears which of its values.
struct FeatureKind
{
    std::uint8_t id = 0; ///< 1..kMostFeatureKinds
    std::string name;
    std::vector<FeatureValue> values; ///< from one end to the other, as gradients run
    std::string unknownMembers{};     ///< see Scene::unknownMembers

    static constexpr auto fields();
    [[nodiscard]] const FeatureValue* find(std::string_view valueName) const; ///< null: none
    friend bool operator==(const FeatureKind&, const FeatureKind&) = default;
};

using FeatureKinds = std::vector<FeatureKind>;

/// What a scene begins with: emotions and outfits for the built-in cast, and for any template with
/// clips and slots that are called so.
[[nodiscard]] const FeatureKinds& readyFeatures();

[[nodiscard]] const FeatureKind* findKind(const FeatureKinds& kinds, std::string_view name);
[[nodiscard]] const FeatureKind* findKind(const FeatureKinds& kinds, std::uint8_t id);
/// The kind that has the value; null: none has.
[[nodiscard]] const FeatureKind* kindOf(const FeatureKinds& kinds, FeatureId value);
/// Values of all kinds, in their order.
struct NamedFeature
{
    std::uint32_t id = 0;
    std::string name;
    std::string kind;
};
[[nodiscard]] std::vector<NamedFeature> allFeatures(const FeatureKinds& kinds);
[[nodiscard]] const FeatureValue* findFeature(const FeatureKinds& kinds, FeatureId value);

namespace featurefields {

/// A list inside an entry; `add` is what the button that makes it longer says.
[[nodiscard]] constexpr FieldMeta list(const char* key, const char* add, const char* doc,
                                       const char* section = "")
{
    return {.key = key, .label = add, .doc = doc, .section = section};
}

[[nodiscard]] constexpr FieldMeta weight()
{
    return {.key = "weight",
            .label = QT_TRANSLATE_NOOP("Fields", "Weight"),
            .tip = QT_TRANSLATE_NOOP("Fields", "How often, against the others"),
            .doc = "how often, against the others",
            .high = 1e6,
            .sliderHigh = 10.0};
}

[[nodiscard]] constexpr FieldMeta curve(const char* key, const char* of)
{
    return {.key = key,
            .label = QT_TRANSLATE_NOOP("Fields", "Frequency"),
            .tip = QT_TRANSLATE_NOOP("Fields", "How often low (left) to high values (right) come: "
                                               "draw it; a double click makes all equal"),
            .doc = of,
            .high = 1e6};
}

inline constexpr std::array kRoles{
    FieldChoice{"any", QT_TRANSLATE_NOOP("Fields", "any clip"),
                QT_TRANSLATE_NOOP("Fields", "Whatever it is for; who sits plays those to sit with, "
                                            "gaits are walked with")},
    FieldChoice{"idle", QT_TRANSLATE_NOOP("Fields", "at rest, standing")},
    FieldChoice{"walk", QT_TRANSLATE_NOOP("Fields", "walking")},
    FieldChoice{"run", QT_TRANSLATE_NOOP("Fields", "running")},
    FieldChoice{"fly", QT_TRANSLATE_NOOP("Fields", "flying")},
    FieldChoice{"sit", QT_TRANSLATE_NOOP("Fields", "at rest, sitting")}};

} // namespace featurefields

constexpr auto FeatureClip::fields()
{
    using S = FeatureClip;
    return std::tuple(
        field(&S::clip, {.key = "clip",
                         .label = QT_TRANSLATE_NOOP("Fields", "Name"),
                         .tip = QT_TRANSLATE_NOOP("Fields", "Words of the clip's name: “cheer” is "
                                                            "also “sit_cheer”"),
                         .doc = "the words of its name: \"cheer\" is also \"sit_cheer\"; empty: "
                                "any of the role",
                         .role = FieldRole::Clip}),
        field(&S::role, {.key = "role",
                         .label = QT_TRANSLATE_NOOP("Fields", "For"),
                         .doc = "what it is for; any: whatever it is",
                         .choices = featurefields::kRoles}),
        field(&S::weight, featurefields::weight()));
}

constexpr auto FeatureMaterial::fields()
{
    return std::tuple(field(&FeatureMaterial::name, {.key = "name",
                                                     .label = QT_TRANSLATE_NOOP("Fields", "Name"),
                                                     .doc = "of the slot's materials",
                                                     .role = FieldRole::Material}),
                      field(&FeatureMaterial::weight, featurefields::weight()));
}

constexpr auto FeatureSlot::fields()
{
    using S = FeatureSlot;
    return std::tuple(
        field(&S::slot, {.key = "slot",
                         .label = QT_TRANSLATE_NOOP("Fields", "Slot"),
                         .tip = QT_TRANSLATE_NOOP("Fields", "Words of the slot's name; empty: all "
                                                            "that is worn and not named beside"),
                         .doc = "the words of its name; empty: what is worn and no other names",
                         .role = FieldRole::Slot}),
        field(&S::colors, {.key = "colors",
                           .label = QT_TRANSLATE_NOOP("Fields", "Colours"),
                           .doc = "of which one is drawn for each; none: as it is"}),
        field(&S::strength, {.key = "strength",
                             .label = QT_TRANSLATE_NOOP("Fields", "Strength"),
                             .doc = "of the tint",
                             .step = 0.05}),
        field(&S::replaces,
              {.key = "replaces",
               .label = QT_TRANSLATE_NOOP("Fields", "The colour itself"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Else it multiplies the material's"),
               .doc = "the colour itself; else it multiplies the material's"}),
        field(&S::materials,
              featurefields::list("materials", QT_TRANSLATE_NOOP("Fields", "Add Material"),
                                  "one of which is drawn")));
}

constexpr auto FeaturePart::fields()
{
    using S = FeaturePart;
    return std::tuple(
        field(&S::part, {.key = "part",
                         .label = QT_TRANSLATE_NOOP("Fields", "Part"),
                         .tip = QT_TRANSLATE_NOOP("Fields", "Words of the part's name; empty: all"),
                         .doc = "the words of its name; empty: all",
                         .role = FieldRole::Part}),
        field(&S::isShown, {.key = "shown",
                            .label = QT_TRANSLATE_NOOP("Fields", "Shown"),
                            .doc = "whether it is seen"}));
}

constexpr auto FeatureValue::fields()
{
    using S = FeatureValue;
    using C = FieldContext;
    return std::tuple(
        field(&S::id, {.key = "id",
                       .doc = "what columns and rules have: of no other value of the scene",
                       .low = 1.0,
                       .high = 65535.0}),
        field(&S::name, {.key = "name",
                         .label = QT_TRANSLATE_NOOP("Fields", "Name"),
                         .doc = "as scripts and brushes call it"}),
        field(&S::color, {.key = "color",
                          .label = QT_TRANSLATE_NOOP("Fields", "Shown in"),
                          .doc = "in which the editor shows it"}),
        field(&S::templates, {.key = "templates",
                              .label = QT_TRANSLATE_NOOP("Fields", "Templates"),
                              .doc = "ids of those it is limited to; none: all",
                              .high = 65535.0,
                              .role = FieldRole::Template,
                              .zero = QT_TRANSLATE_NOOP("Fields", "all")}),
        field(&S::clips, featurefields::list("clips", QT_TRANSLATE_NOOP("Fields", "Add Clip"),
                                             "of which one is drawn for each",
                                             QT_TRANSLATE_NOOP("Fields", "Clips"))),
        field(&S::setsPhase, {.key = "sets_phase",
                              .label = QT_TRANSLATE_NOOP("Fields", "A start of one's own"),
                              .doc = "whether it sets the phase",
                              .section = QT_TRANSLATE_NOOP("Fields", "Timing")}),
        field(&S::phase, {.key = "phase",
                          .label = QT_TRANSLATE_NOOP("Fields", "Phase"),
                          .doc = "0–1 of the clip at time 0",
                          .step = 0.05})
            .when([](const S& s, const C&) { return s.setsPhase; }),
        field(&S::phaseCurve, featurefields::curve("phase_curve", "how often phases come"))
            .when([](const S& s, const C&) { return s.setsPhase; }),
        field(&S::setsSpeed, {.key = "sets_speed",
                              .label = QT_TRANSLATE_NOOP("Fields", "How fast clips play"),
                              .doc = "whether it sets the speed"}),
        field(&S::speed, {.key = "speed",
                          .label = QT_TRANSLATE_NOOP("Fields", "Speed"),
                          .doc = "of playback, 1 as authored",
                          .high = 100.0,
                          .sliderLow = 0.0,
                          .sliderHigh = 4.0,
                          .step = 0.05})
            .when([](const S& s, const C&) { return s.setsSpeed; }),
        field(&S::speedCurve, featurefields::curve("speed_curve", "how often speeds come"))
            .when([](const S& s, const C&) { return s.setsSpeed; }),
        field(&S::setsWalkSpeed, {.key = "sets_walk_speed",
                                  .label = QT_TRANSLATE_NOOP("Fields", "How fast they walk"),
                                  .doc = "whether it sets the walking speed",
                                  .section = QT_TRANSLATE_NOOP("Fields", "Walking")}),
        field(&S::walkSpeed, {.key = "walk_speed",
                              .label = QT_TRANSLATE_NOOP("Fields", "Walking speed"),
                              .doc = "at height 1",
                              .unit = QT_TRANSLATE_NOOP("Fields", " m/s"),
                              .high = 10.0,
                              .sliderLow = 0.0,
                              .sliderHigh = 4.0})
            .when([](const S& s, const C&) { return s.setsWalkSpeed; }),
        field(&S::walkSpeedCurve,
              featurefields::curve("walk_speed_curve", "how often walking speeds come"))
            .when([](const S& s, const C&) { return s.setsWalkSpeed; }),
        field(&S::setsHeight, {.key = "sets_height",
                               .label = QT_TRANSLATE_NOOP("Fields", "How tall they are"),
                               .doc = "whether it sets the height",
                               .section = QT_TRANSLATE_NOOP("Fields", "Size")}),
        field(&S::height, {.key = "height",
                           .label = QT_TRANSLATE_NOOP("Fields", "Height"),
                           .doc = "a scale",
                           .low = kMinScale,
                           .high = kMaxScale,
                           .sliderLow = 0.5,
                           .sliderHigh = 2.0,
                           .step = 0.05})
            .when([](const S& s, const C&) { return s.setsHeight; }),
        field(&S::heightCurve, featurefields::curve("height_curve", "how often heights come"))
            .when([](const S& s, const C&) { return s.setsHeight; }),
        field(&S::setsGirth, {.key = "sets_girth",
                              .label = QT_TRANSLATE_NOOP("Fields", "How stout they are"),
                              .doc = "whether it sets the girth"}),
        field(&S::girth, {.key = "girth",
                          .label = QT_TRANSLATE_NOOP("Fields", "Girth"),
                          .doc = "a scale",
                          .low = kMinScale,
                          .high = kMaxScale,
                          .sliderLow = 0.5,
                          .sliderHigh = 2.0,
                          .step = 0.05})
            .when([](const S& s, const C&) { return s.setsGirth; }),
        field(&S::girthCurve, featurefields::curve("girth_curve", "how often girths come"))
            .when([](const S& s, const C&) { return s.setsGirth; }),
        field(&S::slots, featurefields::list("slots", QT_TRANSLATE_NOOP("Fields", "Add Slot"),
                                             "how slots look",
                                             QT_TRANSLATE_NOOP("Fields", "Colours and materials"))),
        field(&S::parts,
              featurefields::list("parts", QT_TRANSLATE_NOOP("Fields", "Add Part"),
                                  "which parts are seen", QT_TRANSLATE_NOOP("Fields", "Parts"))));
}

constexpr auto FeatureKind::fields()
{
    using S = FeatureKind;
    return std::tuple(
        field(&S::id, {.key = "id",
                       .doc = "the number of the column that says who bears which of its values",
                       .low = 1.0,
                       .high = kMostFeatureKinds}),
        field(&S::name, {.key = "name",
                         .label = QT_TRANSLATE_NOOP("Fields", "Name"),
                         .doc = "as scripts and brushes call it"}),
        field(&S::values, featurefields::list(
                              "values", "", "in order, from one end of a gradient to the other")));
}

} // namespace crowd::model

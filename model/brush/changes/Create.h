// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "model/brush/BrushInfo.h"
#include "model/brush/Heading.h"
#include "model/brush/Mask.h"

namespace crowd::model {

struct TakenFrom;

struct SeatGridSettings
{
    bool isOn = true;
    std::vector<int> ranks;  ///< ascending; empty: all
    std::vector<int> wedges; ///< ascending; empty: all

    [[nodiscard]] bool allows(int rank, int wedge) const;
    [[nodiscard]] bool isLimited() const { return !ranks.empty() || !wedges.empty(); }
    static constexpr auto fields();
    friend bool operator==(const SeatGridSettings&, const SeatGridSettings&) = default;
};

/// Creates people.
struct CreateSettings
{
    std::vector<TemplateWeight> mix;
    float minimalDistance = 0.6F;    ///< metres between foot points, also to those already there
    ValueRange height{0.95F, 1.05F}; ///< scale
    ValueRange girth{0.95F, 1.05F};  ///< scale
    std::vector<PaintColor> palette; ///< tints of clothes; empty: none
    float paletteStrength = 1.0F;    ///< 0..1
    bool variesOutfit = true;        ///< any material of each slot, else the first
    /// Any skin, hair and face; unset: as variesOutfit.
    std::optional<bool> variesFaces;
    bool variesParts = false; ///< each part worn or not, else as the template has them
    ValueRange phase{0.0F, 1.0F};
    std::vector<ClipWeight> clips; ///< empty: the template's default, seated on a seat
    HeadingSettings heading{HeadingMode::Random};
    float density = 1.0F;       ///< persons per m², filling areas without seat grid
    float seatPercent = 100.0F; ///< share of the free seats, filling areas with seat grid
    SeatGridSettings seats;
    /// Also on roofs, crowns of trees and wherever else nobody can walk to. Strokes of before there
    /// was a choice say nothing of it.
    bool anywhere = true;
    std::uint32_t group = 0; ///< GroupId that new ones come into; 0: none

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    static std::string take(BrushSettings& brush, const TakenFrom& from);
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    friend bool operator==(const CreateSettings&, const CreateSettings&) = default;
};

inline constexpr BrushInfo CreateSettings::kInfo{
    .id = "create",
    .name = QT_TRANSLATE_NOOP("Tools", "Create Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Create"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Spray new characters into the scene"),
    .shortcut = "C",
    .order = 10,
    .section = BrushSection::Crowd,
    .family = StrokeFamily::Creation,
    .scriptKind = "CREATE",
    .scriptName = "create",
    .scriptClass = "CreateSettings",
    .doc = "Who is created, and how.",
    .hint = QT_TRANSLATE_NOOP(
        "BrushTool", "Drag: create characters · + −: how many · Ctrl+click: more of the kind"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters created"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Create %n character(s)")};

/// What a form of the scene has use for: free seats to choose from, clothes, faces and parts.
[[nodiscard]] bool hasSeats(const FieldContext& context);
[[nodiscard]] bool createsOnSeats(const FieldContext& context);
[[nodiscard]] bool hasOutfits(const FieldContext& context);
[[nodiscard]] bool hasFaces(const FieldContext& context);
[[nodiscard]] bool hasParts(const FieldContext& context);
/// Whether the area is filled at once: circle or rectangle; a share of it is meant.
[[nodiscard]] bool fillsArea(const FieldContext& context);
[[nodiscard]] bool takesShare(const FieldContext& context);

constexpr auto SeatGridSettings::fields()
{
    using S = SeatGridSettings;
    using C = FieldContext;
    return std::tuple(
        field(&S::isOn,
              {.key = "is_on",
               .label = QT_TRANSLATE_NOOP("Fields", "Only on free seats"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Seat grid: characters sit down where they may"),
               .doc = "Create on free seats only.",
               .section = QT_TRANSLATE_NOOP("Fields", "Places"),
               .isRemembered = false})
            .when([](const S&, const C& c) { return hasSeats(c); }),
        field(&S::ranks,
              {.key = "ranks",
               .label = QT_TRANSLATE_NOOP("Fields", "Rows"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Rows counted from the front, as 1, 3-5"),
               .doc = "Empty: all. Assign a whole list.",
               .low = std::numeric_limits<int>::min(),
               .high = std::numeric_limits<int>::max(),
               .role = FieldRole::SeatNumbers,
               .isRemembered = false})
            .when([](const S&, const C& c) { return createsOnSeats(c); }),
        field(&S::wedges, {.key = "wedges",
                           .label = QT_TRANSLATE_NOOP("Fields", "Wedges"),
                           .tip = QT_TRANSLATE_NOOP("Fields", "Wedges of seats, as 1, 3-5"),
                           .doc = "Empty: all. Assign a whole list.",
                           .low = std::numeric_limits<int>::min(),
                           .high = std::numeric_limits<int>::max(),
                           .role = FieldRole::SeatNumbers,
                           .isBeside = true,
                           .isRemembered = false})
            .when([](const S&, const C& c) { return createsOnSeats(c); }));
}

constexpr auto CreateSettings::fields()
{
    using S = CreateSettings;
    using C = FieldContext;
    const auto onGround = [](const S&, const C& c) { return !createsOnSeats(c); };
    return std::tuple(
        field(&S::mix,
              {.key = "mix", .doc = "Template (or its id) → weight.", .isRemembered = false}),
        field(&S::seats, {.key = "seats"}),
        field(&S::seatPercent, {.key = "seat_percent",
                                .label = QT_TRANSLATE_NOOP("Fields", "Of the seats"),
                                .doc = "Per cent, rectangles.",
                                .unit = " %",
                                .high = 100.0,
                                .sliderLow = 1.0,
                                .sliderHigh = 100.0,
                                .step = 5.0,
                                .decimals = 0})
            .when([](const S&, const C& c) { return createsOnSeats(c) && takesShare(c); }),
        field(&S::anywhere,
              {.key = "anywhere",
               .label = QT_TRANSLATE_NOOP("Fields", "Anywhere"),
               .tip = QT_TRANSLATE_NOOP(
                   "Fields", "Also on roofs, trees and wherever else nobody can walk to"),
               .doc = "Also on roofs, trees and wherever else nobody can walk to. False: only "
                      "where people can walk, which takes seconds to find on large stages."})
            .when(onGround),
        field(&S::density, {.key = "density",
                            .label = QT_TRANSLATE_NOOP("Fields", "Density"),
                            .doc = "Persons per m², rectangles.",
                            .unit = QT_TRANSLATE_NOOP("Fields", " /m²"),
                            .high = 100.0,
                            .sliderLow = 0.05,
                            .sliderHigh = 6.0,
                            .isLogarithmic = true})
            .when([](const S&, const C& c) { return !createsOnSeats(c) && fillsArea(c); }),
        field(&S::minimalDistance, {.key = "minimal_distance",
                                    .label = QT_TRANSLATE_NOOP("Fields", "Distance"),
                                    .doc = "Metres.",
                                    .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                                    .low = 0.0,
                                    .high = 1e6,
                                    .sliderLow = 0.1,
                                    .sliderHigh = 10.0,
                                    .isLogarithmic = true})
            .when(onGround),
        field(&S::height, {.key = "height",
                           .label = QT_TRANSLATE_NOOP("Fields", "Height"),
                           .doc = "Scale, (lowest, highest).",
                           .low = kMinScale,
                           .high = kMaxScale,
                           .sliderLow = 0.5,
                           .sliderHigh = 2.0,
                           .step = 0.01,
                           .role = FieldRole::Stature,
                           .section = QT_TRANSLATE_NOOP("Fields", "Variation")}),
        field(&S::girth, {.key = "girth",
                          .label = QT_TRANSLATE_NOOP("Fields", "Girth"),
                          .doc = "Scale, (lowest, highest).",
                          .low = kMinScale,
                          .high = kMaxScale,
                          .sliderLow = 0.5,
                          .sliderHigh = 2.0,
                          .step = 0.01}),
        field(&S::phase, {.key = "phase",
                          .label = QT_TRANSLATE_NOOP("Fields", "Phase"),
                          .doc = "(lowest, highest), 0–1 of the clip at time 0.",
                          .step = 0.05}),
        field(&S::paletteStrength, {.key = "palette_strength",
                                    .label = QT_TRANSLATE_NOOP("Fields", "Tint"),
                                    .doc = "0–1.",
                                    .unit = " %",
                                    .sliderLow = 0.0,
                                    .sliderHigh = 100.0,
                                    .step = 5.0,
                                    .decimals = 0,
                                    .shownScale = 100.0}),
        field(&S::variesOutfit,
              {.key = "varies_outfit",
               .label = QT_TRANSLATE_NOOP("Fields", "Outfits"),
               .tip = QT_TRANSLATE_NOOP("Fields",
                                        "Each wears any of the clothes that the template has"),
               .doc = "Any material of each slot, else the first."})
            .when([](const S&, const C& c) { return hasOutfits(c); }),
        field(&S::variesFaces,
              {.key = "varies_faces",
               .label = QT_TRANSLATE_NOOP("Fields", "Faces"),
               .tip = QT_TRANSLATE_NOOP(
                   "Fields", "Each has any of the skins, faces and hair that the template has"),
               .doc = "Any skin, hair and face; None: as varies_outfit.",
               .isBeside = true})
            .when([](const S&, const C& c) { return hasFaces(c); }),
        field(&S::variesParts,
              {.key = "varies_parts",
               .label = QT_TRANSLATE_NOOP("Fields", "Parts"),
               .tip = QT_TRANSLATE_NOOP(
                   "Fields", "Each wears some of the template's parts, as hats and bags"),
               .doc = "Each part worn or not, else as the template has them.",
               .isBeside = true})
            .when([](const S&, const C& c) { return hasParts(c); }),
        field(&S::palette, {.key = "palette",
                            .doc = "List of (red, green, blue), 0–255. Assign a whole list.",
                            .low = 0.0}),
        field(&S::group,
              {.key = "group",
               .label = QT_TRANSLATE_NOOP("Fields", "Group"),
               .tip = QT_TRANSLATE_NOOP("Fields", "The group that new characters come into"),
               .doc = "Id of the group that new ones come into; 0: none.",
               .high = std::numeric_limits<std::uint32_t>::max(),
               .step = 1.0,
               .decimals = 0,
               .role = FieldRole::Group,
               .isRemembered = false,
               .zero = QT_TRANSLATE_NOOP("Fields", "none")})
            .when([](const S&, const C& c) { return hasGroups(c); }),
        field(&S::heading, {.key = "facing"}).when(onGround),
        field(&S::clips, {.key = "clips",
                          .label = QT_TRANSLATE_NOOP("Fields", "Clips"),
                          .doc = "Name → weight; empty: what suits the place.",
                          .section = QT_TRANSLATE_NOOP("Fields", "Clips (none: what suits)")}));
}

} // namespace crowd::model

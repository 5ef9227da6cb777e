// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <tuple>
#include <vector>

#include <QtCore/QtGlobal>

#include "model/base/Values.h"
#include "model/describe/Field.h"
#include "model/rules/RuleKind.h"
#include "model/rules/RuleValues.h"

/// Facts that fields of many kinds share: keys, legal ranges and the ranges of the controls. What
/// is given stays; labels stand in front of a control, and fields without one beside it need none.
namespace crowd::model::rulefields {

/// A number with its key and ranges; those of the control are the legal ones where both are 0.
[[nodiscard]] constexpr FieldMeta numeric(FieldMeta meta, const char* key, double low, double high,
                                          double sliderLow = 0.0, double sliderHigh = 0.0)
{
    meta.key = *meta.key == 0 ? key : meta.key;
    meta.low = low;
    meta.high = high;
    if (meta.sliderLow == 0.0 && meta.sliderHigh == 0.0) {
        meta.sliderLow = sliderLow;
        meta.sliderHigh = sliderHigh;
    }
    const double most = meta.sliderHigh != 0.0 ? meta.sliderHigh : high;
    meta.step = most <= 1.0 ? 0.05 : 0.5;
    return meta;
}

[[nodiscard]] constexpr FieldMeta seconds(FieldMeta meta)
{
    meta.unit = QT_TRANSLATE_NOOP("Rules", " s");
    return numeric(meta, "seconds", 0.0, kMaxSeconds, 0.0, 3600.0);
}

[[nodiscard]] constexpr FieldMeta metres(FieldMeta meta)
{
    meta.unit = QT_TRANSLATE_NOOP("Rules", " m");
    return numeric(meta, "metres", 0.0, kMaxRuleMetres, 0.0, 1000.0);
}

[[nodiscard]] constexpr FieldMeta value(FieldMeta meta)
{
    return numeric(meta, "value", -kMaxNumber, kMaxNumber);
}

[[nodiscard]] constexpr FieldMeta reference(FieldMeta meta, const char* key, FieldRole role)
{
    meta.role = role;
    meta = numeric(meta, key, 0.0, kNotChosen);
    return meta;
}

[[nodiscard]] constexpr FieldMeta place(FieldMeta meta)
{
    return reference(meta, "place", FieldRole::Place);
}

[[nodiscard]] constexpr FieldMeta path(FieldMeta meta)
{
    return reference(meta, "path", FieldRole::Path);
}

[[nodiscard]] constexpr FieldMeta number(FieldMeta meta)
{
    return reference(meta, "number", FieldRole::ArtistNumber);
}

[[nodiscard]] constexpr FieldMeta state(FieldMeta meta)
{
    return reference(meta, "state", FieldRole::State);
}

[[nodiscard]] constexpr FieldMeta light(FieldMeta meta)
{
    return reference(meta, "light", FieldRole::Light);
}

[[nodiscard]] constexpr FieldMeta feature(FieldMeta meta)
{
    return reference(meta, "feature", FieldRole::Feature);
}

/// 0: any.
[[nodiscard]] constexpr FieldMeta relation(FieldMeta meta)
{
    meta.zero = QT_TRANSLATE_NOOP("Rules", "relations of any kind");
    return reference(meta, "relation", FieldRole::Relation);
}

[[nodiscard]] constexpr FieldMeta tag(FieldMeta meta)
{
    meta.role = FieldRole::Tag;
    return numeric(meta, "tag", 0.0, kTagCount - 1);
}

[[nodiscard]] constexpr FieldMeta event(FieldMeta meta)
{
    meta.key = "event";
    meta.role = FieldRole::Event;
    return meta;
}

[[nodiscard]] constexpr FieldMeta clips(FieldMeta meta)
{
    meta.key = "clips";
    meta.role = FieldRole::Clip;
    return numeric(meta, "clips", 0.0, kMaxNumber);
}

inline constexpr std::array kComparisons{FieldChoice{"less", QT_TRANSLATE_NOOP("Rules", "below")},
                                         FieldChoice{"equal", QT_TRANSLATE_NOOP("Rules", "at")},
                                         FieldChoice{"more", QT_TRANSLATE_NOOP("Rules", "above")}};

[[nodiscard]] constexpr FieldMeta comparison()
{
    return {.key = "compare", .doc = "how it is compared with the value", .choices = kComparisons};
}

inline constexpr std::array kAims{
    FieldChoice{"sender", QT_TRANSLATE_NOOP("Rules", "whoever it came from")},
    FieldChoice{"tagged", QT_TRANSLATE_NOOP("Rules", "the nearest with")},
    FieldChoice{"place", QT_TRANSLATE_NOOP("Rules", "a place")},
    FieldChoice{"related", QT_TRANSLATE_NOOP("Rules", "the nearest of their")}};
/// Of what is about people alone. Files may say otherwise.
inline constexpr std::array kPersonAims{
    kAims[0], kAims[1],
    FieldChoice{.key = kAims[2].key, .label = kAims[2].label, .isOffered = false}, kAims[3]};

/// Whom or what a kind that is an AimChoice is about.
template<class S>
[[nodiscard]] constexpr auto aim(std::span<const FieldChoice> choices = kAims,
                                 const char* noPlace = "")
{
    return std::tuple(
        field<S, ActionAim>(&S::aim,
                            {.key = "aim", .doc = "whom or what it is about", .choices = choices}),
        field<S, std::uint8_t>(&S::tag, tag({.doc = "of whom is meant", .isBeside = true}))
            .when([](const S& s, const FieldContext&) { return s.aim == ActionAim::Tagged; }),
        field<S, PlaceId>(&S::place,
                          place({.doc = "that is meant", .isBeside = true, .zero = noPlace}))
            .when([](const S& s, const FieldContext&) { return s.aim == ActionAim::Place; }),
        field<S, std::uint32_t>(
            &S::relation,
            relation({.doc = "by which those are related who are meant; 0: any", .isBeside = true}))
            .when([](const S& s, const FieldContext&) { return s.aim == ActionAim::Related; }));
}

template<class S>
[[nodiscard]] constexpr auto personAim()
{
    return aim<S>(kPersonAims, QT_TRANSLATE_NOOP("Rules", "choose…"));
}

} // namespace crowd::model::rulefields

// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "model/describe/Field.h"

/// What the parts of a rule say of themselves: each kind of trigger, condition or action is a
/// struct with fields() (see Field.h), a KindText kText and sentences(). All texts are literals in
/// the translation context "Rules".
namespace crowd::model {

struct KindText
{
    const char* key;          ///< in files and scripts
    const char* name;         ///< in menus, and in forms where it follows yes or no
    const char* doc = "";     ///< for the manual, English
    bool beginsGroup = false; ///< of the menu
    const char* yes = "";     ///< conditions: what stands before the name where it must hold
    const char* no = "";      ///< and where it must not
    bool hasParts = false;    ///< actions: deeper ones below it belong to it
    bool isWalk = false;      ///< actions: whoever does it may go somewhere
    const char* alone = "";   ///< in a menu without yes or no before it; empty: as the name
};

/// One way of saying what a part of a rule is, with its fields' keys in braces where their values
/// come: "wait about {seconds} s". {inside} stands for what belongs to an action.
template<class S>
struct Sentence
{
    const char* text;
    bool (*fits)(const S&) = nullptr; ///< null: always
    const char* negated = "";         ///< of conditions that must not hold
};

/// A kind without its type. Lives as long as the program.
struct RuleKind
{
    struct AnySentence
    {
        const char* text;
        const char* negated;
        std::function<bool(const void*)> fits;
    };

    KindText text;
    std::span<const FieldInfo> fields;
    std::vector<AnySentence> sentences;
    /// Gives values that suit the kind to one that the artist has just chosen; empty: those of the
    /// kind before do.
    std::function<void(void*)> suit;
};

namespace detail {

template<class S>
[[nodiscard]] RuleKind erasedKind()
{
    RuleKind kind{S::kText, fieldsOf<S>(), {}, {}};
    for (const Sentence<S>& each : S::sentences()) {
        auto& sentence = kind.sentences.emplace_back();
        sentence.text = each.text;
        sentence.negated = each.negated;
        sentence.fits = [fits = each.fits](const void* object) {
            return fits == nullptr || fits(*static_cast<const S*>(object));
        };
    }
    if constexpr (requires(S & object) { object.suit(); }) {
        kind.suit = [](void* object) { static_cast<S*>(object)->suit(); };
    }
    return kind;
}

template<class Data>
struct KindList;
template<class... Kinds>
struct KindList<std::variant<Kinds...>>
{
    static std::span<const RuleKind> all()
    {
        static const std::vector<RuleKind> kAll{erasedKind<Kinds>()...};
        return kAll;
    }
    template<class Kind>
    static constexpr bool has = (std::same_as<Kind, Kinds> || ...);

    static void begin(std::variant<Kinds...>& data, std::size_t index)
    {
        using Make = void (*)(std::variant<Kinds...>&);
        constexpr Make kMake[]{
            [](std::variant<Kinds...>& each) { each.template emplace<Kinds>(); }...};
        kMake[index](data);
    }
};

} // namespace detail

/// All kinds that a variant may hold, by index.
template<class Data>
[[nodiscard]] std::span<const RuleKind> kindsOf()
{
    return detail::KindList<Data>::all();
}

template<class Kind, class Data>
concept KindOf = detail::KindList<Data>::template has<Kind>;

/// One part of a rule: data of one of its kinds.
template<class Data>
struct RulePart
{
    Data data;
    std::string unknownMembers{}; ///< see Scene::unknownMembers

    RulePart() = default;
    template<KindOf<Data> Kind>
    explicit RulePart(Kind kind) : data(std::move(kind))
    {
    }

    template<class Kind>
    [[nodiscard]] bool is() const
    {
        return std::holds_alternative<Kind>(data);
    }
    /// Null: it is of another kind.
    template<class Kind>
    [[nodiscard]] Kind* as()
    {
        return std::get_if<Kind>(&data);
    }
    template<class Kind>
    [[nodiscard]] const Kind* as() const
    {
        return std::get_if<Kind>(&data);
    }
    [[nodiscard]] const RuleKind& kind() const { return kindsOf<Data>()[data.index()]; }
    /// What the kind's fields are members of.
    [[nodiscard]] void* object()
    {
        return std::visit([](auto& each) -> void* { return &each; }, data);
    }
    [[nodiscard]] const void* object() const
    {
        return std::visit([](const auto& each) -> const void* { return &each; }, data);
    }
    /// With the values that a kind begins with.
    void begin(std::size_t kindIndex) { detail::KindList<Data>::begin(data, kindIndex); }
    /// As an artist does: fields of the same name keep their values.
    void change(std::size_t kindIndex)
    {
        if (kindIndex == data.index()) {
            return;
        }
        const RulePart before = *this;
        begin(kindIndex);
        carryOver(before.kind().fields, before.object(), kind().fields, object());
        if (kind().suit) {
            kind().suit(object());
        }
    }
    friend bool operator==(const RulePart&, const RulePart&) = default;
};

/// Stored fields of the same key and type get the values of others.
void carryOver(std::span<const FieldInfo> from, const void* source, std::span<const FieldInfo> to,
               void* target);
/// Index of the kind with that key, or their number.
[[nodiscard]] std::size_t indexOfKind(std::span<const RuleKind> kinds, std::string_view key);
/// The sentence that fits; never null where a kind has one without a condition.
[[nodiscard]] const RuleKind::AnySentence* sentenceOf(const RuleKind& kind, const void* object);
/// Whether forms show it, and what it says counts.
[[nodiscard]] bool isShown(const FieldInfo& field, const void* object);
/// The one of that key that is shown; else null.
[[nodiscard]] const FieldInfo* shownField(const RuleKind& kind, const void* object,
                                          std::string_view key);

} // namespace crowd::model

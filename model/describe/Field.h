// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <variant>
#include <vector>

#include <QtCore/QtGlobal>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "model/base/Color.h"
#include "model/base/Values.h"
#include "model/describe/FieldMeta.h"

/// Descriptions of what can be set. A settings struct says once what its members are:
///
///     struct WalkSettings
///     {
///         bool setsSpeed = true;
///         ValueRange speed{1.1F, 1.5F};
///
///         static constexpr auto fields()
///         {
///             return std::tuple(
///                 field(&WalkSettings::setsSpeed,
///                       {.key = "sets_speed", .label = QT_TRANSLATE_NOOP("Fields", "Change it")}),
///                 field(&WalkSettings::speed, {.key = "speed", .low = 0.0, .high = 10.0}));
///         }
///     };
///
/// and fieldsOf<WalkSettings>() is the list that forms, files, scripts, recordings and checks are
/// ordinary functions over. Texts are literals in the translation context "Fields".
namespace crowd::model {

struct Scene;
struct BrushSettings;

/// A value of any described member. Integers of all widths and members of enumerations are
/// std::int64_t here; float stays float, so that its text is as short as its precision.
using FieldValue = std::variant<bool, std::int64_t, float, double, std::string, PaintColor, Tint,
                                ValueRange, glm::vec3, glm::quat, std::optional<bool>,
                                std::vector<int>, std::vector<PaintColor>, std::vector<ClipWeight>,
                                std::vector<TemplateWeight>, DistributionCurve>;

/// What a field's being shown may depend on besides its own struct; null where there is none.
struct FieldContext
{
    const Scene* scene = nullptr;
    const BrushSettings* brush = nullptr;
};

/// A member with its facts. S: the struct; T: the member's type.
template<class S, class T>
struct Field
{
    using Condition = bool (*)(const S&, const FieldContext&);

    T S::*member;
    FieldMeta meta;
    Condition isShown = nullptr;

    /// Shown in forms only where the condition holds.
    [[nodiscard]] constexpr Field when(Condition condition) const
    {
        Field copy = *this;
        copy.isShown = condition;
        return copy;
    }
};

template<class S, class T>
[[nodiscard]] constexpr Field<S, T> field(T S::*member, const FieldMeta& meta)
{
    return {member, meta, nullptr};
}

/// What forms show and set although no member is just that. See computed() and stored().
template<class S, class T>
struct ComputedField
{
    T (*get)(const S&);
    void (*set)(S&, T);
    FieldMeta meta;
    bool (*isShown)(const S&, const FieldContext&) = nullptr;

    /// As Field::when.
    [[nodiscard]] constexpr ComputedField when(bool (*condition)(const S&,
                                                                 const FieldContext&)) const
    {
        ComputedField copy = *this;
        copy.isShown = condition;
        return copy;
    }
};

/// Files and scripts do not have it.
template<class S, class T>
[[nodiscard]] constexpr ComputedField<S, T> computed(T (*get)(const S&), void (*set)(S&, T),
                                                     FieldMeta meta)
{
    meta.isStored = false;
    return {get, set, meta};
}

/// What is stored in another form than its member has, as an enumeration that files know as a bool.
template<class S, class T>
[[nodiscard]] constexpr ComputedField<S, T> stored(T (*get)(const S&), void (*set)(S&, T),
                                                   const FieldMeta& meta)
{
    return {get, set, meta};
}

/// All fields of a base of S, which are shown only where the condition holds.
template<class S, class Base>
struct InheritedFields
{
    bool (*isShown)(const S&, const FieldContext&);
};
template<class S, class Base>
[[nodiscard]] constexpr InheritedFields<S, Base> inherited(bool (*isShown)(const S&,
                                                                           const FieldContext&))
{
    return {isShown};
}

/// A described member without its types. Lives as long as the program.
struct FieldInfo
{
    FieldMeta meta;
    /// Index of the value's alternative in FieldValue; std::variant_npos for a struct with fields
    /// of its own and for a list of such.
    std::size_t type = std::variant_npos;
    std::function<FieldValue(const void*)> get;
    /// The value has the field's alternative; integers that do not fit and choices that there are
    /// none of are the caller's to refuse (see fitsField).
    std::function<void(void*, const FieldValue&)> set;
    std::function<bool(const void*, const FieldContext&)> isShown; ///< empty: always

    // A struct with fields of its own.
    std::span<const FieldInfo> children{};
    std::type_index structType = typeid(void);
    std::function<void*(void*)> childOf;
    /// What it, or an item of a list, keeps of members that this version does not know, JSON text;
    /// empty: it keeps none.
    std::function<std::string*(void*)> unknownOf;

    // A list of structs with fields of their own, which are `children`.
    std::function<std::size_t(const void*)> count;
    std::function<void(void*, std::size_t)> resize;
    std::function<void(void*, std::size_t)> erase;
    std::function<void*(void*, std::size_t)> itemOf;
    const void* newItem = nullptr; ///< as an item, or a struct of its own, begins
    std::size_t itemBytes = 0;     ///< of an item's struct

    [[nodiscard]] bool isList() const { return static_cast<bool>(count); }
    [[nodiscard]] bool isGroup() const { return type == std::variant_npos && !isList(); }
    template<class T>
    [[nodiscard]] bool is() const;
};

/// All fields of a struct, in the order in which it describes them.
template<class S>
[[nodiscard]] std::span<const FieldInfo> fieldsOf();

template<class S>
concept Described = requires
{
    S::fields();
};

namespace detail {

template<class T>
constexpr auto fieldValueType()
{
    if constexpr (std::is_enum_v<T> || (std::is_integral_v<T> && !std::is_same_v<T, bool>)) {
        return std::type_identity<std::int64_t>();
    } else {
        return std::type_identity<T>();
    }
}
template<class T>
using FieldValueOf = typename decltype(fieldValueType<T>())::type;

template<class T, class Variant>
struct AlternativeIndex;
template<class T, class... Alternatives>
struct AlternativeIndex<T, std::variant<Alternatives...>>
{
    static constexpr std::size_t find()
    {
        constexpr bool kIsSame[] = {std::is_same_v<T, Alternatives>...};
        std::size_t index = 0;
        while (index < sizeof...(Alternatives) && !kIsSame[index]) {
            ++index;
        }
        return index;
    }
    static constexpr std::size_t value = find();
    static_assert(value < sizeof...(Alternatives), "FieldValue holds no value of this type");
};

template<class T>
struct ItemOf
{
    using type = void;
};
template<class Item>
struct ItemOf<std::vector<Item>>
{
    using type = Item;
};
/// A list of structs that describe themselves.
template<class T>
concept ListOfDescribed = Described<typename ItemOf<T>::type>;

/// `listOf` finds the list in what it is a member of.
template<class List, class ListOf>
void eraseList(FieldInfo& info, const ListOf& listOf)
{
    using Item = typename List::value_type;
    info.children = fieldsOf<Item>();
    info.structType = typeid(Item);
    info.count = [listOf](const void* object) {
        return listOf(const_cast<void*>(object)).size(); // only read
    };
    info.resize = [listOf](void* object, std::size_t count) { listOf(object).resize(count); };
    info.erase = [listOf](void* object, std::size_t index) {
        List& list = listOf(object);
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
    };
    info.itemOf = [listOf](void* object, std::size_t index) -> void* {
        return &listOf(object)[index];
    };
    static const Item kNew;
    info.newItem = &kNew;
    info.itemBytes = sizeof(Item);
    info.unknownOf = [](void* item) { return &static_cast<Item*>(item)->unknownMembers; };
}

/// Owner: the struct whose fields they are; S: that, or one of its bases.
template<class Owner, class S, class T>
[[nodiscard]] FieldInfo erased(const Field<S, T>& field)
{
    const auto in = [](const void* object) {
        return static_cast<const S*>(static_cast<const Owner*>(object));
    };
    const auto editable = [](void* object) { return static_cast<S*>(static_cast<Owner*>(object)); };
    FieldInfo info;
    info.meta = field.meta;
    const auto member = field.member;
    if (field.isShown != nullptr) {
        info.isShown = [in, shown = field.isShown](const void* object,
                                                   const FieldContext& context) {
            return shown(*in(object), context);
        };
    }
    if constexpr (Described<T>) {
        info.children = fieldsOf<T>();
        info.structType = typeid(T);
        info.childOf = [member, editable](void* object) -> void* {
            return &(editable(object)->*member);
        };
        static const T kNew;
        info.newItem = &kNew;
        if constexpr (requires(T & child) { child.unknownMembers; }) {
            info.unknownOf = [](void* child) { return &static_cast<T*>(child)->unknownMembers; };
        }
    } else if constexpr (ListOfDescribed<T>) {
        eraseList<T>(info,
                     [member, editable](void* object) -> T& { return editable(object)->*member; });
    } else {
        using Value = FieldValueOf<T>;
        info.type = AlternativeIndex<Value, FieldValue>::value;
        info.get = [member, in](const void* object) {
            return FieldValue(static_cast<Value>(in(object)->*member));
        };
        info.set = [member, editable](void* object, const FieldValue& value) {
            editable(object)->*member = static_cast<T>(std::get<Value>(value));
        };
    }
    return info;
}

template<class Owner, class S, class T>
[[nodiscard]] FieldInfo erased(const ComputedField<S, T>& field)
{
    using Value = FieldValueOf<T>;
    FieldInfo info;
    info.meta = field.meta;
    if (field.isShown != nullptr) {
        info.isShown = [shown = field.isShown](const void* object, const FieldContext& context) {
            return shown(*static_cast<const S*>(object), context);
        };
    }
    info.type = AlternativeIndex<Value, FieldValue>::value;
    info.get = [get = field.get](const void* object) {
        return FieldValue(static_cast<Value>(get(*static_cast<const S*>(object))));
    };
    info.set = [set = field.set](void* object, const FieldValue& value) {
        set(*static_cast<S*>(object), static_cast<T>(std::get<Value>(value)));
    };
    return info;
}

template<class Owner, class Described>
void appendFields(std::vector<FieldInfo>& fields, const Described& field)
{
    fields.push_back(erased<Owner>(field));
}
template<class Owner, class Base>
void appendFields(std::vector<FieldInfo>& fields, const InheritedFields<Owner, Base>& base)
{
    const auto append = [&](const auto& field) {
        FieldInfo info = erased<Owner>(field);
        info.isShown = [all = base.isShown, own = info.isShown](const void* object,
                                                                const FieldContext& context) {
            return all(*static_cast<const Owner*>(object), context) &&
                   (!own || own(object, context));
        };
        fields.push_back(std::move(info));
    };
    std::apply([&append](const auto&... each) { (append(each), ...); }, Base::fields());
}

} // namespace detail

template<class T>
bool FieldInfo::is() const
{
    return type == detail::AlternativeIndex<T, FieldValue>::value;
}

template<class S>
std::span<const FieldInfo> fieldsOf()
{
    static const std::vector<FieldInfo> kFields = std::apply(
        [](const auto&... each) {
            std::vector<FieldInfo> fields;
            fields.reserve(sizeof...(each));
            (detail::appendFields<S>(fields, each), ...);
            return fields;
        },
        S::fields());
    return kFields;
}

} // namespace crowd::model

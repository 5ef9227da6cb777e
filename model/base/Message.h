// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <QtCore/QtGlobal>

namespace crowd::model {

/// What is said to the artist: an id and arguments, so that the window can say it in his language;
/// scripts, the command line and logs say it in English. The id is the English text, with %1 to %9
/// where the arguments go, a literal in the translation context "Messages":
///
///     Message(QT_TRANSLATE_NOOP("Messages", "The file %1 is empty."), path)
///
/// Messages may be arguments of others. A text alone is what others said (the system, a library, a
/// file): the same in all languages. Copies share what they hold; any thread.
class Message
{
public:
    /// Its value in the language of whoever asks.
    using Translate = std::string (*)(const char* id);

    Message() = default;
    Message(std::string text); // NOLINT(google-explicit-constructor)
    template<class... Arguments>
    Message(const char* id, const Arguments&... arguments) // NOLINT(google-explicit-constructor)
        : Message(id, {argument(arguments)...}, 0)
    {
    }

    [[nodiscard]] bool empty() const { return m_content == nullptr; }
    [[nodiscard]] std::string english() const;
    /// The same with every id translated; an empty translation is none.
    [[nodiscard]] std::string in(Translate translate) const;

    /// Whether they say the same.
    friend bool operator==(const Message& a, const Message& b)
    {
        return a.english() == b.english();
    }
    friend std::ostream& operator<<(std::ostream& stream, const Message& message)
    {
        return stream << message.english();
    }

private:
    struct Content
    {
        std::string text; ///< an id, or what is said as it is
        bool isId = false;
        std::vector<Message> arguments;
    };

    Message(const char* id, std::initializer_list<Message> arguments, int);

    static Message argument(const Message& message) { return message; }
    static Message argument(const std::string& text) { return Message(text); }
    static Message argument(std::string_view text) { return Message(std::string(text)); }
    static Message argument(const char* text) { return Message(std::string(text)); }
    template<class Number>
    requires std::is_arithmetic_v<Number>
    static Message argument(Number number) { return Message(numberText(number)); }
    template<class Number>
    static std::string numberText(Number number)
    {
        if constexpr (std::is_floating_point_v<Number>) {
            return realText(static_cast<double>(number), std::is_same_v<Number, float>);
        } else {
            return std::to_string(number);
        }
    }
    /// As short as reads back as the same number.
    static std::string realText(double number, bool isFloat);

    std::shared_ptr<const Content> m_content;
};

} // namespace crowd::model

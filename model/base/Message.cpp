// SPDX-License-Identifier: MIT
#include "model/base/Message.h"

#include <array>
#include <charconv>

#include "model/base/ShownText.h"

namespace crowd::model {

namespace {

std::string unchanged(const char* id)
{
    return id;
}

} // namespace

Message::Message(std::string text)
{
    if (!text.empty()) {
        auto content = std::make_shared<Content>();
        content->text = wellFormed(std::move(text));
        m_content = std::move(content);
    }
}

Message::Message(const char* id, std::initializer_list<Message> arguments, int)
{
    auto content = std::make_shared<Content>();
    content->text = id;
    content->isId = true;
    content->arguments = arguments;
    m_content = std::move(content);
}

std::string Message::english() const
{
    return in(&unchanged);
}

std::string Message::in(Translate translate) const
{
    if (!m_content || !m_content->isId) {
        return m_content ? m_content->text : std::string();
    }
    std::string pattern = translate(m_content->text.c_str());
    if (pattern.empty()) {
        pattern = m_content->text;
    }
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool isPlace = pattern[i] == '%' && i + 1 < pattern.size() && pattern[i + 1] >= '1' &&
                             pattern[i + 1] <= '9';
        const std::size_t place = isPlace ? static_cast<std::size_t>(pattern[i + 1] - '1') : 0;
        if (isPlace && place < m_content->arguments.size()) {
            text += m_content->arguments[place].in(translate);
            ++i;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

std::string Message::realText(double number, bool isFloat)
{
    std::array<char, 32> text{};
    char* const first = text.data();
    char* const last = first + text.size();
    const auto end = isFloat ? std::to_chars(first, last, static_cast<float>(number)).ptr
                             : std::to_chars(first, last, number).ptr;
    return {first, end};
}

} // namespace crowd::model

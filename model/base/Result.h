// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "model/base/Message.h"

namespace crowd::model {

/// What went wrong, in words for the artist: the thing, the place in it, and the way out.
struct Error
{
    Message said;        ///< one or more full sentences
    std::string message; ///< the same in English, UTF-8

    Error(Message what) : said(std::move(what)), message(said.english()) {}
    Error(std::string what) : Error(Message(std::move(what))) {}
    /// As a Message is made.
    template<class... Arguments>
    Error(const char* id, const Arguments&... arguments) : Error(Message(id, arguments...))
    {
    }
};

/// A value or an Error. Used for everything that can go wrong in the world (files, shaders,
/// scripts); mistakes of the programmer assert instead.
template<class T>
class [[nodiscard]] Result
{
public:
    Result(T value) : m_data(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_data(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool isOk() const { return m_data.index() == 0; }
    explicit operator bool() const { return isOk(); }

    [[nodiscard]] const T& value() const&
    {
        assert(isOk());
        return std::get<0>(m_data);
    }
    [[nodiscard]] T& value() &
    {
        assert(isOk());
        return std::get<0>(m_data);
    }
    [[nodiscard]] T&& value() &&
    {
        assert(isOk());
        return std::get<0>(std::move(m_data));
    }
    [[nodiscard]] const Error& error() const
    {
        assert(!isOk());
        return std::get<1>(m_data);
    }

private:
    std::variant<T, Error> m_data;
};

template<>
class [[nodiscard]] Result<void>
{
public:
    Result() = default;
    Result(Error error) : m_error(std::move(error)) {}

    [[nodiscard]] bool isOk() const { return !m_error; }
    explicit operator bool() const { return isOk(); }
    [[nodiscard]] const Error& error() const
    {
        assert(m_error);
        return *m_error;
    }

private:
    std::optional<Error> m_error;
};

} // namespace crowd::model

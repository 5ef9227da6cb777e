// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <QtCore/QByteArray>

/// Damages glTF files, the same way for the same seed: bytes, spans, the structure of the JSON, and
/// the numbers of the binary chunk.
class GltfMutator
{
public:
    using Json = nlohmann::json;

    explicit GltfMutator(std::uint64_t seed) : m_state(seed * 0x9E3779B97F4A7C15ULL + 1) {}

    /// `whole` is a .glb or the JSON of a .gltf.
    QByteArray mutate(const QByteArray& whole)
    {
        const bool isGlb = whole.startsWith("glTF") && whole.size() > 20;
        switch (below(isGlb ? 5 : 4)) {
        case 0:
            return damageBytes(whole);
        case 1:
        case 2:
        case 3:
            return isGlb ? mutateGlbJson(whole) : mutateJsonText(whole);
        default:
            return damageNumbers(whole);
        }
    }

    /// For the .bin beside a .gltf.
    QByteArray damageBytes(QByteArray bytes)
    {
        for (std::size_t i = 0, n = 1 + below(4); i < n && !bytes.isEmpty(); ++i) {
            const auto at = static_cast<qsizetype>(below(static_cast<std::size_t>(bytes.size())));
            const auto length = static_cast<qsizetype>(1 + below(64));
            switch (below(5)) {
            case 0:
                bytes.truncate(at);
                break;
            case 1:
                bytes.insert(at, bytes.mid(at, length));
                break;
            case 2:
                bytes.remove(at, length);
                break;
            default:
                bytes[at] = static_cast<char>(next());
                break;
            }
        }
        return bytes;
    }

private:
    std::uint64_t next()
    {
        m_state ^= m_state << 13U;
        m_state ^= m_state >> 7U;
        m_state ^= m_state << 17U;
        return m_state;
    }

    std::size_t below(std::size_t limit) { return static_cast<std::size_t>(next() % limit); }

    /// Floats that are none, or huge, and whole numbers at the ends of their ranges.
    QByteArray damageNumbers(QByteArray bytes)
    {
        constexpr std::array<std::uint32_t, 8> kValues{
            0x7FC00000U, 0x7F800000U, 0xFF800000U, 0x7F7FFFFFU, 0xFFFFFFFFU, 0x80000000U, 1U, 0U};
        const std::uint32_t jsonBytes = wordAt(bytes, 12);
        const qsizetype begin = 28 + static_cast<qsizetype>(jsonBytes);
        for (std::size_t i = 0, n = 1 + below(32); i < n && begin + 4 < bytes.size(); ++i) {
            const auto words = static_cast<std::size_t>((bytes.size() - begin) / 4);
            const std::uint32_t value = kValues[below(kValues.size())];
            std::memcpy(bytes.data() + begin + static_cast<qsizetype>(below(words)) * 4, &value, 4);
        }
        return bytes;
    }

    QByteArray mutateGlbJson(const QByteArray& whole)
    {
        const auto size = static_cast<qsizetype>(wordAt(whole, 12));
        QByteArray json = mutateJsonText(whole.mid(20, size));
        json.append(QByteArray((4 - json.size() % 4) % 4, ' '));
        QByteArray out = whole.left(12);
        appendWord(out, static_cast<std::uint32_t>(json.size()));
        out += whole.mid(16, 4) + json + whole.mid(20 + size);
        const auto length = static_cast<std::uint32_t>(out.size());
        std::memcpy(out.data() + 8, &length, 4);
        return out;
    }

    QByteArray mutateJsonText(const QByteArray& text)
    {
        Json root = Json::parse(text.begin(), text.end(), nullptr, false);
        if (root.is_discarded()) {
            return damageBytes(text);
        }
        for (std::size_t i = 0, n = 1 + below(3); i < n; ++i) {
            mutateValue(root);
        }
        return QByteArray::fromStdString(root.dump(-1, ' ', false, Json::error_handler_t::replace));
    }

    /// Walks down to a value somewhere in the tree and bends it.
    void mutateValue(Json& value)
    {
        Json* at = &value;
        while (at->is_structured() && !at->empty() && below(8) != 0) {
            auto child = at->begin();
            std::advance(child, static_cast<std::ptrdiff_t>(below(at->size())));
            at = &*child;
        }
        if (at->is_structured() && !at->empty() && below(3) != 0) {
            mutateContainer(*at);
        } else if (at->is_number() && below(2) == 0) {
            *at = std::floor(at->get<double>()) + static_cast<double>(below(9)) - 4.0;
        } else {
            *at = strangeValue();
        }
    }

    void mutateContainer(Json& container)
    {
        auto child = container.begin();
        std::advance(child, static_cast<std::ptrdiff_t>(below(container.size())));
        if (below(2) == 0) {
            container.erase(child);
        } else if (container.is_array()) {
            container.push_back(Json(*child));
        } else {
            auto other = container.begin();
            std::advance(other, static_cast<std::ptrdiff_t>(below(container.size())));
            const Json copy = *child;
            *other = copy;
        }
    }

    Json strangeValue()
    {
        switch (below(13)) {
        case 0:
            return nullptr;
        case 1:
            return -1;
        case 2:
            return 0;
        case 3:
            return std::numeric_limits<std::int64_t>::max();
        case 4:
            return 4294967295U;
        case 5:
            return 1e38;
        case 6:
            return 1e308;
        case 7:
            return 0.5;
        case 8:
            return "";
        case 9:
            return Json::array();
        case 10:
            return Json::object();
        case 11:
            return true;
        default:
            return static_cast<std::uint64_t>(below(70000));
        }
    }

    static std::uint32_t wordAt(const QByteArray& bytes, qsizetype at)
    {
        std::uint32_t word = 0;
        std::memcpy(&word, bytes.constData() + at, 4);
        return word;
    }

    static void appendWord(QByteArray& bytes, std::uint32_t word)
    {
        bytes.append(reinterpret_cast<const char*>(&word), 4);
    }

    std::uint64_t m_state;
};

// SPDX-License-Identifier: MIT
#include "app/pictures/Cryptomatte.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <map>
#include <utility>

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

namespace crowd::app {

namespace {

constexpr const char* kIndividuals = "crypto_individual";
constexpr const char* kTemplates = "crypto_template";

std::uint32_t murmurHash3(const std::string& text)
{
    const auto scrambled = [](std::uint32_t block) {
        return std::rotl(block * 0xCC9E2D51U, 15) * 0x1B873593U;
    };
    std::uint32_t hash = 0;
    std::size_t at = 0;
    for (; at + sizeof(std::uint32_t) <= text.size(); at += sizeof(std::uint32_t)) {
        std::uint32_t block = 0;
        std::memcpy(&block, text.data() + at, sizeof(block));
        hash = std::rotl(hash ^ scrambled(block), 13) * 5U + 0xE6546B64U;
    }
    std::uint32_t rest = 0;
    std::memcpy(&rest, text.data() + at, text.size() - at);
    hash ^= scrambled(rest) ^ static_cast<std::uint32_t>(text.size());
    hash = (hash ^ hash >> 16U) * 0x85EBCA6BU;
    hash = (hash ^ hash >> 13U) * 0xC2B2AE35U;
    return hash ^ hash >> 16U;
}

/// Numbers by the keys of what is covered.
using MatteNumbers = std::map<std::uint32_t, std::uint32_t>;

/// What templates are called, each otherwise.
std::map<model::TemplateId, std::string> templateNames(const model::CrowdFrame& frame)
{
    std::map<model::TemplateId, std::string> names;
    std::map<std::string, int> uses;
    if (frame.templates) {
        for (const model::TemplateEntry& entry : *frame.templates) {
            names[entry.id] = entry.name;
            ++uses[entry.name];
        }
    }
    for (auto& [id, name] : names) {
        if (name.empty() || uses[name] > 1) {
            name += "#" + std::to_string(id);
        }
    }
    return names;
}

/// use(row, name).
template<class Use>
void forPeople(const model::CrowdFrame& frame, const Use& use)
{
    const std::map<model::TemplateId, std::string> names = templateNames(frame);
    const auto ids = frame.population.ids();
    const auto templates = frame.population.column(model::columns::templateId);
    for (std::size_t row = 0; row < ids.size(); ++row) {
        const auto found = names.find(templates[row]);
        const std::string kind = found != names.end() ? found->second : std::string();
        use(static_cast<std::uint32_t>(row), kind + "." + std::to_string(ids[row]));
    }
}

MatteNumbers individualNumbers(const model::CrowdFrame& frame)
{
    MatteNumbers numbers;
    forPeople(frame, [&numbers](std::uint32_t row, const std::string& person) {
        numbers.emplace_hint(numbers.end(), row, matteNumber(person));
    });
    return numbers;
}

MatteNumbers templateNumbers(const model::CrowdFrame& frame)
{
    MatteNumbers numbers;
    for (const auto& [id, name] : templateNames(frame)) {
        numbers[id] = matteNumber(name);
    }
    return numbers;
}

/// Most of the pixel first, as the specification wants it.
Coverage::Pixel ranked(Coverage::Pixel pixel, const MatteNumbers& numbers)
{
    for (Coverage::Share& share : pixel) {
        const auto found = share.samples > 0 ? numbers.find(share.key) : numbers.end();
        share = found != numbers.end() ? Coverage::Share{found->second, share.samples}
                                       : Coverage::Share{};
    }
    std::ranges::sort(pixel, [](const Coverage::Share& a, const Coverage::Share& b) {
        return a.samples != b.samples ? a.samples > b.samples : a.key < b.key;
    });
    return pixel;
}

/// Two ranks a channel group: number and coverage of one, then of the next.
void addChannels(ExrLayer& layer, const std::string& name, const Coverage::Pixels& pixels,
                 const MatteNumbers& numbers, int samples)
{
    constexpr std::array kEnds{".R", ".G", ".B", ".A"};
    const std::size_t first = layer.channels.size();
    for (std::size_t rank = 0; rank < Coverage::kRanks / 2; ++rank) {
        for (const char* end : kEnds) {
            std::string group = name + "0" + std::to_string(rank);
            layer.channels.push_back({group.append(end), std::vector<float>(pixels.size()), false});
        }
    }
    const auto at = [&layer, first](std::size_t channel, std::size_t pixel) -> float& {
        return std::get<std::vector<float>>(layer.channels[first + channel].values)[pixel];
    };
    const auto all = static_cast<float>(std::max(samples, 1));
    for (std::size_t pixel = 0; pixel < pixels.size(); ++pixel) {
        const Coverage::Pixel shares = ranked(pixels[pixel], numbers);
        for (std::size_t rank = 0; rank < shares.size(); ++rank) {
            at(rank * 2, pixel) = std::bit_cast<float>(shares[rank].key);
            at(rank * 2 + 1, pixel) = static_cast<float>(shares[rank].samples) / all;
        }
    }
}

void count(Coverage::Pixel& pixel, std::uint32_t key)
{
    auto* const share = std::ranges::find_if(
        pixel, [key](const Coverage::Share& each) { return each.samples == 0 || each.key == key; });
    if (share != pixel.end()) {
        share->key = key;
        ++share->samples;
    }
}

QString hexOf(std::uint32_t number)
{
    constexpr int kDigits = 8;
    constexpr int kHex = 16;
    return QStringLiteral("%1").arg(number, kDigits, kHex, QLatin1Char('0'));
}

void addNotes(ExrHeader& header, const char* name, const QJsonObject& manifest)
{
    constexpr int kKeyDigits = 7;
    const std::string key =
        "cryptomatte/" + hexOf(murmurHash3(name)).left(kKeyDigits).toStdString() + "/";
    header.notes[key + "name"] = name;
    header.notes[key + "hash"] = "MurmurHash3_32";
    header.notes[key + "conversion"] = "uint32_to_float32";
    header.notes[key + "manifest"] =
        QJsonDocument(manifest).toJson(QJsonDocument::Compact).toStdString();
}

} // namespace

std::uint32_t matteNumber(const std::string& name)
{
    constexpr std::uint32_t kExponent = 0xFFU << 23U;
    const std::uint32_t hash = murmurHash3(name);
    const std::uint32_t exponent = hash & kExponent;
    return exponent == 0 || exponent == kExponent ? hash ^ 1U << 23U : hash;
}

void Coverage::add(const render::AovPicture& picture, const model::CrowdFrame& frame)
{
    m_individuals.resize(picture.rows.size());
    m_templates.resize(picture.rows.size());
    ++m_samples;
    const auto templates = frame.population.column(model::columns::templateId);
    for (std::size_t i = 0; i < picture.rows.size(); ++i) {
        const std::int32_t row = picture.rows[i];
        if (row >= 0 && static_cast<std::size_t>(row) < templates.size()) {
            count(m_individuals[i], static_cast<std::uint32_t>(row));
            count(m_templates[i], templates[static_cast<std::size_t>(row)]);
        }
    }
}

ExrLayer cryptomatteLayer(const Coverage& coverage, const model::CrowdFrame& frame)
{
    ExrLayer layer{"cryptomatte", {}};
    addChannels(layer, kIndividuals, coverage.individuals(), individualNumbers(frame),
                coverage.samples());
    addChannels(layer, kTemplates, coverage.templates(), templateNumbers(frame),
                coverage.samples());
    return layer;
}

void addCryptomatteNotes(const model::CrowdFrame& frame, ExrHeader& header)
{
    QJsonObject individuals;
    QJsonObject templates;
    forPeople(frame, [&individuals](std::uint32_t /*row*/, const std::string& person) {
        individuals[QString::fromStdString(person)] = hexOf(matteNumber(person));
    });
    for (const auto& [id, name] : templateNames(frame)) {
        templates[QString::fromStdString(name)] = hexOf(matteNumber(name));
    }
    addNotes(header, kIndividuals, individuals);
    addNotes(header, kTemplates, templates);
}

} // namespace crowd::app

// SPDX-License-Identifier: MIT
#include "app/pictures/Cryptomatte.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <map>
#include <span>
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

/// Of people in a frame, by row.
struct MatteNumbers
{
    std::vector<std::uint32_t> individuals;
    std::vector<std::uint32_t> templates;
};

/// What templates are called, each otherwise.
std::map<model::TemplateId, std::string> templateNames(const model::CrowdFrame& frame)
{
    std::map<model::TemplateId, std::string> names;
    if (frame.templates) {
        for (const model::TemplateEntry& entry : *frame.templates) {
            names[entry.id] = entry.name;
        }
    }
    return names;
}

template<class Use>
void forPeople(const model::CrowdFrame& frame, const Use& use)
{
    const std::map<model::TemplateId, std::string> names = templateNames(frame);
    const auto ids = frame.population.ids();
    const auto templates = frame.population.column(model::columns::templateId);
    for (std::size_t row = 0; row < ids.size(); ++row) {
        const auto found = names.find(templates[row]);
        const std::string kind = found != names.end() ? found->second : std::string();
        use(kind, kind + "." + std::to_string(ids[row]));
    }
}

MatteNumbers numbersOf(const model::CrowdFrame& frame)
{
    MatteNumbers numbers;
    numbers.individuals.reserve(frame.population.size());
    numbers.templates.reserve(frame.population.size());
    forPeople(frame, [&numbers](const std::string& kind, const std::string& person) {
        numbers.individuals.push_back(matteNumber(person));
        numbers.templates.push_back(matteNumber(kind));
    });
    return numbers;
}

struct Matte
{
    std::uint32_t number = 0;
    std::uint32_t samples = 0;
};
using PixelMattes = std::array<Matte, Coverage::kRanks>;

/// Most of the pixel first, as the specification wants it.
PixelMattes mattesOf(const Coverage::Pixel& pixel, std::span<const std::uint32_t> numbers)
{
    PixelMattes mattes{};
    std::size_t count = 0;
    for (const Coverage::Share& share : pixel) {
        const auto row = static_cast<std::size_t>(share.row);
        if (share.samples == 0 || row >= numbers.size()) {
            break;
        }
        const auto known =
            std::find_if(mattes.begin(), mattes.begin() + static_cast<std::ptrdiff_t>(count),
                         [&](const Matte& matte) { return matte.number == numbers[row]; });
        known->number = numbers[row];
        known->samples += share.samples;
        count = std::max(count, static_cast<std::size_t>(known - mattes.begin()) + 1);
    }
    std::sort(mattes.begin(), mattes.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Matte& a, const Matte& b) {
                  return a.samples != b.samples ? a.samples > b.samples : a.number < b.number;
              });
    return mattes;
}

/// Two ranks a channel group: number and coverage of one, then of the next.
void addChannels(ExrLayer& layer, const std::string& name, const Coverage& coverage,
                 std::span<const std::uint32_t> numbers)
{
    constexpr std::array kEnds{".R", ".G", ".B", ".A"};
    const std::size_t first = layer.channels.size();
    for (std::size_t rank = 0; rank < Coverage::kRanks / 2; ++rank) {
        for (const char* end : kEnds) {
            std::vector<float> values(coverage.pixels().size());
            std::string group = name + "0" + std::to_string(rank);
            layer.channels.push_back({group.append(end), std::move(values), false});
        }
    }
    const auto at = [&layer, first](std::size_t channel, std::size_t pixel) -> float& {
        return std::get<std::vector<float>>(layer.channels[first + channel].values)[pixel];
    };
    const auto all = static_cast<float>(std::max(coverage.samples(), 1));
    for (std::size_t pixel = 0; pixel < coverage.pixels().size(); ++pixel) {
        const PixelMattes mattes = mattesOf(coverage.pixels()[pixel], numbers);
        for (std::size_t rank = 0; rank < mattes.size(); ++rank) {
            at(rank * 2, pixel) = std::bit_cast<float>(mattes[rank].number);
            at(rank * 2 + 1, pixel) = static_cast<float>(mattes[rank].samples) / all;
        }
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

void Coverage::add(const render::AovPicture& picture)
{
    m_pixels.resize(picture.rows.size());
    ++m_samples;
    for (std::size_t i = 0; i < m_pixels.size(); ++i) {
        const std::int32_t row = picture.rows[i];
        if (row < 0) {
            continue;
        }
        auto* const share = std::ranges::find_if(
            m_pixels[i], [row](const Share& each) { return each.samples == 0 || each.row == row; });
        if (share != m_pixels[i].end()) {
            share->row = row;
            ++share->samples;
        }
    }
}

ExrLayer cryptomatteLayer(const Coverage& coverage, const model::CrowdFrame& frame)
{
    const MatteNumbers numbers = numbersOf(frame);
    ExrLayer layer{"cryptomatte", {}};
    addChannels(layer, kIndividuals, coverage, numbers.individuals);
    addChannels(layer, kTemplates, coverage, numbers.templates);
    return layer;
}

void addCryptomatteNotes(const model::CrowdFrame& frame, ExrHeader& header)
{
    QJsonObject individuals;
    QJsonObject templates;
    forPeople(frame, [&](const std::string& kind, const std::string& person) {
        individuals[QString::fromStdString(person)] = hexOf(matteNumber(person));
        templates[QString::fromStdString(kind)] = hexOf(matteNumber(kind));
    });
    addNotes(header, kIndividuals, individuals);
    addNotes(header, kTemplates, templates);
}

} // namespace crowd::app

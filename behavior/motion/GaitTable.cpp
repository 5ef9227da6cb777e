// SPDX-License-Identifier: MIT
#include "behavior/motion/GaitTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "behavior/motion/StrideKernel.h"
#include "model/bake/Pose.h"
#include "model/bake/Skinning.h"
#include "model/brush/ClipChoice.h"

namespace crowd::behavior {

namespace {

constexpr float kStandBelow = 0.2F; ///< m/s
constexpr float kHysteresis = 0.15F;
constexpr float kHardestBraking = 5.0F; ///< m/s²
constexpr float kSole = 0.04F;          ///< of the height: vertices that low are soles
constexpr double kPassingShare = 0.12;  ///< of a cycle
constexpr int kMoments = 48;            ///< looked at in a clip
constexpr float kNextGait = 1.15F;      ///< times as fast: less is the same gait in other words

/// The vertices of the soles as a mesh of their own.
model::Mesh solesOf(const model::Template& asset)
{
    model::Mesh soles;
    if (asset.levels.empty()) {
        return soles;
    }
    const model::Mesh& mesh = asset.levels.back();
    const auto influences = static_cast<std::size_t>(mesh.influencesPerVertex);
    model::Pose pose;
    model::evaluatePose(asset, asset.defaultClip, 0.0F, pose);
    std::vector<glm::vec3> points(mesh.positions.size());
    model::skin(mesh, pose.bones, points, {});
    soles.influencesPerVertex = mesh.influencesPerVertex;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (points[v].y < kSole * asset.height) {
            soles.positions.push_back(mesh.positions[v]);
            const auto from = static_cast<std::ptrdiff_t>(v * influences);
            const auto to = from + static_cast<std::ptrdiff_t>(influences);
            soles.bones.insert(soles.bones.end(), mesh.bones.begin() + from,
                               mesh.bones.begin() + to);
            soles.weights.insert(soles.weights.end(), mesh.weights.begin() + from,
                                 mesh.weights.begin() + to);
        }
    }
    return soles;
}

/// Where in a clip the soles reach least far from front to back.
std::vector<float> feetTogetherIn(const model::Template& asset, const model::Mesh& soles, int clip)
{
    if (soles.positions.empty()) {
        return {};
    }
    model::Pose pose;
    std::vector<glm::vec3> points(soles.positions.size());
    std::vector<float> reach(kMoments);
    for (int i = 0; i < kMoments; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(kMoments);
        model::evaluatePose(asset, clip,
                            share * asset.clips[static_cast<std::size_t>(clip)].seconds, pose);
        model::skin(soles, pose.bones, points, {});
        const auto [back, front] = std::ranges::minmax(points, {}, &glm::vec3::z);
        reach[static_cast<std::size_t>(i)] = front.z - back.z;
    }
    const auto [least, most] = std::ranges::minmax(reach);
    std::vector<float> places;
    for (std::size_t i = 0; i < reach.size(); ++i) {
        const float before = reach[(i + reach.size() - 1) % reach.size()];
        const float after = reach[(i + 1) % reach.size()];
        if (reach[i] < before && reach[i] <= after && reach[i] < 0.5F * (least + most)) {
            places.push_back(static_cast<float>(i) / static_cast<float>(kMoments));
        }
    }
    return places;
}

} // namespace

GaitTable::GaitTable(const model::TemplateEntry& entry)
{
    if (!entry.asset) {
        return;
    }
    const auto standing = static_cast<std::size_t>(entry.asset->defaultClip);
    const model::Mesh soles = solesOf(*entry.asset);
    std::vector<Candidate> found;
    for (std::size_t i = 0; i < entry.clipNames.size(); ++i) {
        const int index = entry.asset->clipIndex(entry.clipNames[i]);
        if (index < 0) {
            continue;
        }
        const auto clip = static_cast<std::size_t>(index);
        const model::ClipRole role = model::clipRole(entry, i, clip);
        const float seconds = entry.asset->clips[clip].seconds;
        const bool isFree = role == model::ClipRole::Fly;
        const bool moves = model::movesOverGround(entry, i, clip);
        if (clip == standing && m_gaits.empty()) {
            // With nothing to stand with it stands as in the middle of a step.
            const bool isFrozen = moves && model::isGait(role) && !isFree;
            m_gaits.push_back({static_cast<std::uint16_t>(i), 0.0F, seconds, isFree, isFrozen, {}});
        }
        if (moves) {
            found.push_back(
                {{static_cast<std::uint16_t>(i), model::groundSpeed(entry, i, clip), seconds,
                  isFree, false,
                  isFree ? std::vector<float>{} : feetTogetherIn(*entry.asset, soles, index)},
                 role});
        }
    }
    if (!m_gaits.empty()) {
        addMovers(std::move(found));
    }
}

/// By speed, but runs are faster than walks, and of several of one speed the first one counts.
void GaitTable::addMovers(std::vector<Candidate> found)
{
    std::ranges::stable_sort(found, {}, [](const Candidate& each) {
        const int group = !model::isGait(each.role) ? 2 : each.role == model::ClipRole::Run ? 1 : 0;
        return std::pair(group, each.gait.metresPerSecond);
    });
    std::vector<Gait> asked;
    std::size_t before = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const float speed = found[i].gait.metresPerSecond;
        const bool isFaster =
            m_gaits.size() == 1 || speed > kNextGait * m_gaits.back().metresPerSecond;
        if (model::isGait(found[i].role) && isFaster) {
            before = i;
            m_gaits.push_back(std::move(found[i].gait));
        } else if (model::isGait(found[i].role) && found[i].role == found[before].role &&
                   found[i].gait.clip < m_gaits.back().clip) {
            std::swap(found[i].gait, m_gaits.back()); // as fast, and named before it
            asked.push_back(std::move(found[i].gait));
        } else {
            asked.push_back(std::move(found[i].gait));
        }
    }
    m_usual = m_gaits.size();
    m_gaits.insert(m_gaits.end(), asked.begin(), asked.end());
}

bool GaitTable::isMover(std::size_t clip) const
{
    const std::span usual(m_gaits.data(), m_usual);
    return std::ranges::any_of(usual, [clip](const Gait& gait) {
        return gait.clip == clip && gait.metresPerSecond > 0.0F && !gait.isFree;
    });
}

std::size_t GaitTable::gaitOf(std::size_t clip) const
{
    const auto found = std::ranges::find_if(m_gaits, [clip](const Gait& gait) {
        return gait.clip == clip && gait.metresPerSecond > 0.0F;
    });
    return found == m_gaits.end() ? 0 : static_cast<std::size_t>(found - m_gaits.begin());
}

float GaitTable::border(std::size_t upper) const
{
    return upper == 1
               ? kStandBelow
               : std::sqrt(m_gaits[upper - 1].metresPerSecond * m_gaits[upper].metresPerSecond);
}

GaitTable::Limits GaitTable::limits(std::size_t present, std::size_t style) const
{
    constexpr float kNone = std::numeric_limits<float>::infinity();
    const std::size_t gait = std::min(present, m_gaits.size() - 1);
    if (style != 0 && gait != 0) {
        return gait == style ? Limits{kStandBelow * (1.0F - kHysteresis), kNone}
                             : Limits{kNone, -kNone};
    }
    if (gait >= m_usual) {
        return {kNone, -kNone}; // nobody asks for it any more
    }
    return {gait == 0 ? -kNone : border(gait) * (1.0F - kHysteresis),
            gait + 1 == m_usual ? kNone : border(gait + 1) * (1.0F + kHysteresis)};
}

std::size_t GaitTable::choose(std::size_t present, float metresPerSecond, std::size_t style) const
{
    if (style != 0) {
        // One clip at every speed; standing begins and ends as ever.
        const float border = kStandBelow * (present == 0 ? 1.0F + kHysteresis : 1.0F - kHysteresis);
        return metresPerSecond > border ? style : 0;
    }
    std::size_t gait = std::min(present, m_usual - 1);
    while (gait + 1 < m_usual && metresPerSecond > border(gait + 1) * (1.0F + kHysteresis)) {
        ++gait;
    }
    while (gait > 0 && metresPerSecond < border(gait) * (1.0F - kHysteresis)) {
        --gait;
    }
    return gait;
}

float GaitTable::braking(const Gait& gait, double place, float metresPerSecond, float height)
{
    const float squared = metresPerSecond * metresPerSecond;
    const float stride = gait.metresPerSecond * gait.seconds * std::max(height, 0.05F);
    if (gait.feetTogether.empty() || stride <= 0.0F) {
        return kUsualBraking;
    }
    // The first such place that can be reached at all.
    const auto least = static_cast<double>(0.5F * squared / kHardestBraking / stride);
    double nearest = least + 1.0;
    for (const float together : gait.feetTogether) {
        const double way = static_cast<double>(together) - place - least;
        nearest = std::min(nearest, least + way - std::floor(way));
    }
    return 0.5F * squared / (static_cast<float>(nearest) * stride);
}

double GaitTable::nearestTogether(const Gait& gait, double place)
{
    double best = place;
    double least = 1.0;
    for (const float together : gait.feetTogether) {
        const double away = std::remainder(static_cast<double>(together) - place, 1.0);
        if (std::fabs(away) < least) {
            least = std::fabs(away);
            best = static_cast<double>(together);
        }
    }
    return best;
}

bool GaitTable::isAboutToPass(const Gait& gait, double place)
{
    const double ahead = std::remainder(nearestTogether(gait, place) - place, 1.0);
    return gait.feetTogether.empty() || (ahead > -0.02 && ahead < kPassingShare);
}

double GaitTable::placeInto(const Gait& from, const Gait& to, double place)
{
    const double passing = nearestTogether(from, place);
    return from.feetTogether.empty() ? place : place + nearestTogether(to, passing) - passing;
}

float GaitTable::playback(const Gait& gait, float metresPerSecond, float height)
{
    if (gait.metresPerSecond <= 0.0F || gait.isFree) {
        return gait.isFrozen ? 0.0F : 1.0F;
    }
    return metresPerSecond / (gait.metresPerSecond * std::max(height, 0.05F));
}

} // namespace crowd::behavior

// SPDX-License-Identifier: MIT
#include "model/gltf/ImportProposal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "model/bake/Pose.h"
#include "model/gltf/BodyKind.h"
#include "model/gltf/GroundSpeed.h"

namespace crowd::model {

namespace {

constexpr float kSmallestLift = 0.001F;
constexpr std::size_t kMostClips = 256; ///< looked at for the way it walks
constexpr float kQuarter = std::numbers::pi_v<float> / 2.0F;

float largest(const glm::vec3& size)
{
    return std::max({size.x, size.y, size.z});
}

/// Three digits that count, or as many as there are before the point, which some languages write
/// otherwise.
Message number(float value)
{
    const double size = std::abs(static_cast<double>(value));
    const int decimals =
        size > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 9) : 0;
    std::array<char, 64> text{};
    const char* end = std::to_chars(text.data(), text.data() + text.size(),
                                    static_cast<double>(value), std::chars_format::fixed, decimals)
                          .ptr;
    std::string digits(text.data(), static_cast<std::size_t>(end - text.data()));
    if (decimals > 0) {
        digits.erase(digits.find_last_not_of('0') + 1);
    }
    const std::size_t point = digits.find('.');
    const bool isWhole = point == std::string::npos || point + 1 == digits.size();
    return isWhole ? Message(digits.substr(0, point))
                   : Message(QT_TRANSLATE_NOOP("Messages", "%1.%2"), digits.substr(0, point),
                             digits.substr(point + 1));
}

/// Units that files are made in by mistake: centimetres, millimetres, inches, decimetres.
constexpr std::array kUnits{0.01F, 0.001F, 0.0254F, 0.1F, 10.0F, 100.0F, 1000.0F};

float nearestUnit(float extent, float usual)
{
    const auto misfit = [&](float unit) { return std::abs(std::log(extent * unit / usual)); };
    return *std::min_element(kUnits.begin(), kUnits.end(),
                             [&](float a, float b) { return misfit(a) < misfit(b); });
}

/// Two digits that count.
float rounded(float value)
{
    const float step = std::pow(10.0F, std::floor(std::log10(value)) - 1.0F);
    return std::round(value / step) * step;
}

/// To where nobody wonders: by another unit where that fits well, else to what is usual, where that
/// is known.
float proposeScale(const BodyGuess& guess, float extent)
{
    constexpr float kFitsWell = 1.4F;
    if (extent <= 0.0F || (extent >= guess.smallest && extent <= guess.largest)) {
        return 1.0F;
    }
    const float unit = nearestUnit(extent, guess.usual);
    const bool isKnown = guess.kind == BodyKind::Person || guess.kind == BodyKind::Animal;
    const float ratio = extent * unit / guess.usual;
    const bool fits = ratio < kFitsWell && ratio > 1.0F / kFitsWell;
    return isKnown && !fits ? rounded(guess.usual / extent) : unit;
}

/// The height of people, the largest extent of all else.
float extentOf(const BodyGuess& guess, const glm::vec3& size)
{
    return guess.kind == BodyKind::Person ? size.y : largest(size);
}

Message scaleReason(const BodyGuess& guess, float extent, float scale)
{
    if (guess.kind == BodyKind::Person) {
        return {QT_TRANSLATE_NOOP("Messages", "It is built like a person and %1 m tall; import it "
                                              "at scale %2, or at 1 if it is a giant."),
                number(extent), number(scale)};
    }
    if (*guess.word != 0) {
        return {QT_TRANSLATE_NOOP("Messages", "It is named \"%1\" and %2 m large; import it at "
                                              "scale %3, or at 1 if it is meant to be so."),
                guess.word, number(extent), number(scale)};
    }
    return {QT_TRANSLATE_NOOP("Messages", "It is %1 m large as it is; import it at scale %2."),
            number(extent), number(scale)};
}

/// Of what is not proposed, since games have such animals.
std::optional<Message> doubt(const BodyGuess& guess, float extent)
{
    constexpr float kStrange = 2.5F;
    const float ratio = extent / guess.usual;
    if (*guess.word == 0 || (ratio < kStrange && ratio > 1.0F / kStrange)) {
        return std::nullopt;
    }
    return Message{QT_TRANSLATE_NOOP("Messages", "It is named \"%1\" and %2 m large: scale %3 "
                                                 "would make it as large as one."),
                   guess.word, number(extent), number(rounded(guess.usual / extent))};
}

/// Upright along Z: thin and centred in Y, standing on Z = 0.
bool standsAlongZ(const Bounds& bounds)
{
    const glm::vec3 size = bounds.size();
    const bool standsOnZ = std::abs(bounds.low.z) < 0.05F * size.z;
    const bool standsOnY = std::abs(bounds.low.y) < 0.05F * size.y;
    const bool isCentred = std::abs(bounds.center().y) < 0.2F * size.y;
    return standsOnZ && !standsOnY && isCentred && size.z > 1.5F * size.y;
}

struct SideName
{
    std::string base;
    bool isLeft = false;
};

/// "Arm.L", "arm_r", "LeftArm", "mixamorig:RightFoot": the name without its side.
bool splitSide(const std::string& name, SideName& out)
{
    std::string lower = name;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    for (const bool isLeft : {true, false}) {
        const std::string word = isLeft ? "left" : "right";
        if (const std::size_t at = lower.find(word); at != std::string::npos) {
            out = {lower.substr(0, at) + "*" + lower.substr(at + word.size()), isLeft};
            return true;
        }
        for (const char separator : {'.', '_', '-', ' '}) {
            const std::string mark{separator, isLeft ? 'l' : 'r'};
            const std::size_t at = lower.rfind(mark);
            const std::size_t end = at + 2;
            if (at != std::string::npos && at > 0 &&
                (end == lower.size() || lower[end] < 'a' || lower[end] > 'z')) {
                out = {lower.substr(0, at) + "*" + lower.substr(end), isLeft};
                return true;
            }
        }
    }
    return false;
}

bool mirrors(const glm::mat4& matrix)
{
    return glm::determinant(glm::mat3(matrix)) < 0.0F;
}

/// From the right side to the left, summed over pairs of nodes; zero where there are none.
glm::vec3 towardsLeft(const Template& asset)
{
    Pose pose;
    evaluatePose(asset, asset.defaultClip, 0.0F, pose);
    struct Pair
    {
        int left = -1;
        int right = -1;
    };
    std::map<std::string, Pair> pairs;
    for (std::size_t i = 0; i < asset.nodes.size(); ++i) {
        SideName side;
        if (splitSide(asset.nodes[i].name, side)) {
            (side.isLeft ? pairs[side.base].left : pairs[side.base].right) = static_cast<int>(i);
        }
    }
    glm::vec3 sum(0.0F);
    for (const auto& [base, pair] : pairs) {
        if (pair.left >= 0 && pair.right >= 0) {
            const glm::mat4& left = pose.nodeWorld[static_cast<std::size_t>(pair.left)];
            const glm::mat4& right = pose.nodeWorld[static_cast<std::size_t>(pair.right)];
            // In a character that is mirrored as a whole, what is called left is at its right.
            const bool isSwapped = mirrors(left) && mirrors(right);
            sum += glm::vec3(left[3] - right[3]) * (isSwapped ? -1.0F : 1.0F);
        }
    }
    return sum;
}

/// The way it goes in the first clip that goes forwards, zero where there is none.
glm::vec3 walkingWay(const Template& asset)
{
    const std::size_t count = std::min(asset.clips.size(), kMostClips);
    for (std::size_t i = 0; i < count; ++i) {
        std::string name = asset.clips[i].name;
        std::transform(name.begin(), name.end(), name.begin(), [](char c) {
            return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        });
        const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
        const bool isForwards = (has("walk") || has("run") || has("trot") || has("gallop")) &&
                                !has("back") && !has("left") && !has("right") && !has("strafe");
        if (isForwards && asset.clips[i].rootMotionNode >= 0) {
            return asset.clips[i].rootMotion;
        }
        if (isForwards) {
            const glm::vec3 ground = gltf::footVelocity(asset, static_cast<int>(i));
            if (ground != glm::vec3(0.0F)) {
                return -ground;
            }
        }
    }
    return glm::vec3(0.0F);
}

/// Quarter turns about Y that bring the way it faces to +Z.
float turnToFront(const Template& asset, const glm::quat& upright)
{
    const glm::vec3 left = upright * towardsLeft(asset);
    glm::vec3 front = glm::cross(glm::vec3(left.x, 0.0F, left.z), glm::vec3(0.0F, 1.0F, 0.0F));
    if (glm::length(front) < 0.02F * largest(asset.bounds.size())) {
        front = upright * walkingWay(asset);
    }
    if (front.x == 0.0F && front.z == 0.0F) {
        return 0.0F;
    }
    const float heading = std::atan2(front.x, front.z);
    const float quarters = std::round(heading / kQuarter);
    return quarters == 0.0F ? 0.0F : -quarters * kQuarter;
}

Bounds turned(const Bounds& bounds, const ImportSettings& settings)
{
    Bounds out;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 at((corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                           (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                           (corner & 4) != 0 ? bounds.high.z : bounds.low.z);
        out.add(settings.rotation * (at * settings.scale));
    }
    return out;
}

/// What floats a little may be meant to; what sinks is lifted. Nobody sees less than a millimetre.
float proposeLift(const Bounds& bounds)
{
    const float height = bounds.size().y;
    const bool sinks = bounds.low.y < -std::max(0.03F * height, kSmallestLift);
    const bool isFarAbove = bounds.low.y > std::max(height, kSmallestLift);
    return sinks || isFarAbove ? -bounds.low.y : 0.0F;
}

} // namespace

ImportProposal proposeImport(const Template& asset)
{
    ImportProposal proposal;
    ImportSettings& settings = proposal.settings;
    if (asset.bounds.isEmpty()) {
        return proposal;
    }
    const bool isLying = standsAlongZ(asset.bounds);
    const glm::vec3 size = asset.bounds.size();
    const glm::vec3 upright = isLying ? glm::vec3(size.x, size.z, size.y) : size;
    const BodyGuess guess = guessBody(asset, upright);
    const float extent = extentOf(guess, upright);
    settings.scale = proposeScale(guess, extent);
    if (settings.scale != 1.0F) {
        proposal.reasons.push_back(scaleReason(guess, extent, settings.scale));
    } else if (auto strange = doubt(guess, extent)) {
        proposal.reasons.push_back(*std::move(strange));
    }
    if (isLying) {
        settings.rotation = glm::angleAxis(-kQuarter, glm::vec3(1.0F, 0.0F, 0.0F));
        proposal.reasons.emplace_back(QT_TRANSLATE_NOOP(
            "Messages", "It seems to lie on its back: Z was up where it was made."));
    }
    if (const float turn = turnToFront(asset, settings.rotation); turn != 0.0F) {
        settings.rotation = glm::angleAxis(turn, glm::vec3(0.0F, 1.0F, 0.0F)) * settings.rotation;
        proposal.reasons.emplace_back(
            QT_TRANSLATE_NOOP("Messages",
                              "It seems to face another way than +Z; turn it by %1 degrees."),
            number(glm::degrees(turn)));
    }
    const Bounds stood = turned(asset.bounds, settings);
    settings.groundOffset = proposeLift(stood);
    if (settings.groundOffset != 0.0F) {
        proposal.reasons.emplace_back(
            QT_TRANSLATE_NOOP("Messages",
                              "Its lowest point is %1 m from the ground; offset it by %2 m."),
            number(stood.low.y), number(settings.groundOffset));
    }
    proposal.height = stood.size().y;
    return proposal;
}

} // namespace crowd::model

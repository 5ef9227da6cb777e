// SPDX-License-Identifier: MIT
#include "model/gltf/BodyKind.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

namespace crowd::model {

namespace {

using Words = std::set<std::string, std::less<>>;

struct Species
{
    const char* word;
    float metres; ///< from nose to tail, or to the tip of its wings
};

/// Grown ones, rounded.
constexpr std::array kSpecies{
    Species{"ant", 0.02F},      Species{"bear", 2.0F},     Species{"bee", 0.02F},
    Species{"beetle", 0.05F},   Species{"bird", 0.35F},    Species{"bull", 2.5F},
    Species{"butterfly", 0.1F}, Species{"camel", 3.0F},    Species{"cat", 0.8F},
    Species{"chicken", 0.45F},  Species{"cow", 2.4F},      Species{"crocodile", 3.5F},
    Species{"crow", 0.5F},      Species{"deer", 1.9F},     Species{"dog", 1.1F},
    Species{"dolphin", 2.5F},   Species{"donkey", 2.0F},   Species{"duck", 0.5F},
    Species{"eagle", 0.9F},     Species{"elephant", 6.0F}, Species{"fish", 0.4F},
    Species{"fox", 1.2F},       Species{"frog", 0.12F},    Species{"giraffe", 5.0F},
    Species{"goat", 1.4F},      Species{"goose", 0.9F},    Species{"gorilla", 1.7F},
    Species{"hen", 0.45F},      Species{"horse", 2.4F},    Species{"lion", 2.6F},
    Species{"lizard", 0.4F},    Species{"monkey", 0.9F},   Species{"mouse", 0.18F},
    Species{"penguin", 0.8F},   Species{"pig", 1.3F},      Species{"rabbit", 0.45F},
    Species{"rat", 0.4F},       Species{"rooster", 0.5F},  Species{"shark", 3.5F},
    Species{"sheep", 1.3F},     Species{"snake", 1.5F},    Species{"spider", 0.12F},
    Species{"squirrel", 0.4F},  Species{"stag", 2.1F},     Species{"tiger", 2.7F},
    Species{"turtle", 0.6F},    Species{"whale", 12.0F},   Species{"wolf", 1.6F},
    Species{"zebra", 2.4F}};

constexpr std::array<std::string_view, 11> kArms{"arm",   "forearm", "upperarm", "hand",
                                                 "wrist", "elbow",   "thumb",    "finger",
                                                 "hands", "arms",    "clavicle"};
constexpr std::array<std::string_view, 13> kLegs{"leg",   "legs",  "thigh",   "shin", "calf",
                                                 "knee",  "foot",  "feet",    "toe",  "toes",
                                                 "upleg", "ankle", "lowerleg"};
constexpr std::array<std::string_view, 18> kOfAnimals{
    "tail",   "paw",  "hoof",  "snout", "muzzle", "hind", "frontleg", "backleg", "mane",
    "gallop", "trot", "graze", "bark",  "neigh",  "meow", "howl",     "slither", "hindleg"};
constexpr std::array<std::string_view, 14> kOfVehicles{
    "wheel",  "wheels",   "tire",       "tyre",      "turret",  "chassis", "axle",
    "bumper", "steering", "windshield", "headlight", "cockpit", "exhaust", "suspension"};
constexpr std::array<std::string_view, 9> kOfFlyers{"rotor",      "rotors",   "propeller",
                                                    "propellers", "thruster", "thrusters",
                                                    "flying",     "hover",    "jet"};

bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isCapital(char c)
{
    return c >= 'A' && c <= 'Z';
}

/// "LeftForeArm", "front_wheel.001": left, fore, arm; front, wheel.
void addWords(const std::string& name, Words& words)
{
    std::string word;
    for (std::size_t i = 0; i <= name.size(); ++i) {
        const char c = i < name.size() ? name[i] : ' ';
        const bool begins = isCapital(c) && i > 0 && !isCapital(name[i - 1]);
        if ((!isLetter(c) || begins) && !word.empty()) {
            words.insert(word);
            word.clear();
        }
        if (isLetter(c)) {
            word += isCapital(c) ? static_cast<char>(c - 'A' + 'a') : c;
        }
    }
}

Words wordsOf(const Template& asset)
{
    Words words;
    addWords(asset.name, words);
    for (const Node& node : asset.nodes) {
        addWords(node.name, words);
    }
    for (const Clip& clip : asset.clips) {
        addWords(clip.name, words);
    }
    return words;
}

template<std::size_t N>
bool hasAny(const Words& words, const std::array<std::string_view, N>& wanted)
{
    return std::ranges::any_of(wanted, [&](std::string_view each) { return words.contains(each); });
}

BodyGuess animal(const Words& words)
{
    BodyGuess guess{BodyKind::Animal, "", 1.4F, 0.01F, 3.5F};
    for (const Species& each : kSpecies) {
        if (words.contains(std::string_view(each.word))) {
            guess.word = each.word;
            guess.usual = each.metres;
            guess.largest = std::max(guess.largest, each.metres * 1.5F);
            break;
        }
    }
    return guess;
}

bool isNamed(const Words& words)
{
    return std::ranges::any_of(
        kSpecies, [&](const Species& each) { return words.contains(std::string_view(each.word)); });
}

} // namespace

BodyGuess guessBody(const Template& asset, const glm::vec3& size)
{
    const Words words = wordsOf(asset);
    const bool hasArms = hasAny(words, kArms);
    const bool hasLegs = hasAny(words, kLegs);
    if (!hasArms && hasAny(words, kOfFlyers)) {
        return {BodyKind::Flyer, "", 3.0F, 0.1F, 40.0F};
    }
    if (!hasArms && hasAny(words, kOfVehicles)) {
        return {BodyKind::Vehicle, "", 4.5F, 0.3F, 30.0F};
    }
    const bool isLong = size.z > size.y;
    if (hasArms && hasLegs && !isLong) {
        return {BodyKind::Person, "", 1.75F, 0.4F, 2.6F};
    }
    const bool isOnLegs = hasLegs && isLong;
    if (isOnLegs || hasAny(words, kOfAnimals) || (isNamed(words) && asset.clips.size() > 1)) {
        return animal(words);
    }
    return {};
}

} // namespace crowd::model

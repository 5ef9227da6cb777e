// SPDX-License-Identifier: MIT
#include "model/gltf/ClipNames.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace crowd::model::gltf {

namespace {

using Words = std::vector<std::string>;

const std::map<std::string_view, ClipRole>& roleWords()
{
    using enum ClipRole;
    static const std::map<std::string_view, ClipRole> kWords{
        {"walk", Walk},      {"walking", Walk},   {"walks", Walk},   {"move", Walk},
        {"moving", Walk},    {"moves", Walk},     {"march", Walk},   {"marching", Walk},
        {"stroll", Walk},    {"strolling", Walk}, {"amble", Walk},   {"wander", Walk},
        {"wandering", Walk}, {"drive", Walk},     {"driving", Walk}, {"drives", Walk},
        {"gehen", Walk},     {"run", Run},        {"running", Run},  {"runs", Run},
        {"sprint", Run},     {"sprinting", Run},  {"jog", Run},      {"jogging", Run},
        {"trot", Run},       {"trotting", Run},   {"canter", Run},   {"cantering", Run},
        {"gallop", Run},     {"galloping", Run},  {"rennen", Run},   {"fly", Fly},
        {"flying", Fly},     {"flies", Fly},      {"flight", Fly},   {"swim", Fly},
        {"swimming", Fly},   {"swims", Fly},      {"glide", Fly},    {"gliding", Fly},
        {"flap", Fly},       {"flapping", Fly},   {"fliegen", Fly},  {"idle", Idle},
        {"idling", Idle},    {"idles", Idle},     {"stand", Idle},   {"standing", Idle},
        {"breathe", Idle},   {"breathing", Idle}, {"breath", Idle},  {"wait", Idle},
        {"waiting", Idle},   {"rest", Idle},      {"resting", Idle}, {"relax", Idle},
        {"relaxed", Idle},   {"survey", Idle},    {"hover", Idle},   {"hovering", Idle},
        {"stehen", Idle},    {"sit", Sit},        {"sitting", Sit},  {"sits", Sit},
        {"seated", Sit},     {"sitzen", Sit},
    };
    return kWords;
}

/// Of a gait where nothing better is.
const std::map<std::string_view, ClipRole>& weakWords()
{
    using enum ClipRole;
    static const std::map<std::string_view, ClipRole> kWords{
        {"crawl", Walk},  {"crawling", Walk},   {"slither", Walk}, {"slithering", Walk},
        {"hop", Walk},    {"hopping", Walk},    {"sneak", Walk},   {"sneaking", Walk},
        {"creep", Walk},  {"locomotion", Walk}, {"forward", Walk}, {"forwards", Walk},
        {"laufen", Walk}, {"float", Fly},       {"floating", Fly},
    };
    return kWords;
}

/// Words with which a clip is something else, whatever stands beside.
bool isActionWord(const std::string& word)
{
    static const std::set<std::string_view> kWords{
        "air",       "aim",      "aiming",   "attack",  "attacking",  "back",        "backward",
        "backwards", "begin",    "bite",     "block",   "bwd",        "cast",        "chop",
        "climb",     "climbing", "clap",     "cheer",   "crouch",     "crouched",    "crouching",
        "dance",     "dash",     "dead",     "death",   "die",        "dies",        "dive",
        "dodge",     "down",     "duck",     "eat",     "eating",     "end",         "enter",
        "exit",      "fall",     "falling",  "fight",   "fire",       "floor",       "get",
        "hit",       "hurt",     "impact",   "jump",    "jumping",    "jumps",       "kick",
        "knock",     "land",     "landing",  "leap",    "left",       "lie",         "lying",
        "pick",      "pickup",   "pose",     "punch",   "react",      "reaction",    "reload",
        "reset",     "right",    "roll",     "rolling", "rotate",     "rueckwaerts", "shoot",
        "shooting",  "side",     "sideways", "slash",   "slide",      "spin",        "stab",
        "stairs",    "start",    "stop",     "strafe",  "strafing",   "stun",        "swing",
        "talk",      "throw",    "to",       "tpose",   "transition", "turn",        "turning",
        "up",        "use",      "vault",    "wave",
    };
    return kWords.contains(word);
}

/// Words that say nothing about the use.
bool isNeutralWord(const std::string& word)
{
    static const std::set<std::string_view> kWords{
        "action", "anim",   "animation",  "armature", "base",    "basic",  "casual",
        "clip",   "com",    "cycle",      "default",  "f",       "fast",   "female",
        "final",  "fwd",    "forward",    "forwards", "human",   "in",     "inplace",
        "ip",     "layer",  "loop",       "looped",   "looping", "male",   "man",
        "mixamo", "motion", "natural",    "neutral",  "new",     "normal", "place",
        "rig",    "root",   "rootmotion", "slow",     "take",    "the",    "unarmed",
        "woman",
    };
    return word.size() == 1 || kWords.contains(word);
}

/// The word without what is often written together with it: "walkcycle", "run_fwd" as "runfwd".
std::string stemOf(const std::string& word)
{
    if (roleWords().contains(word) || weakWords().contains(word)) {
        return word;
    }
    for (const char* tail : {"cycle", "loop", "looped", "anim", "animation", "forward", "forwards",
                             "fwd", "inplace", "ip", "f"}) {
        const std::size_t length = std::char_traits<char>::length(tail);
        if (word.size() > length && word.ends_with(tail)) {
            std::string stem = word.substr(0, word.size() - length);
            if (roleWords().contains(stem)) {
                return stem;
            }
        }
    }
    return word;
}

/// Lower-case words: runs of letters, also parted where small letters meet a capital one.
Words wordsOf(const std::string& name)
{
    Words words;
    std::string word;
    const auto finish = [&] {
        if (!word.empty()) {
            words.push_back(stemOf(word));
        }
        word.clear();
    };
    // Blender exports actions as "Armature|Idle".
    const std::string own = name.substr(name.find_last_of('|') + 1);
    for (std::size_t i = 0; i < own.size(); ++i) {
        const auto letter = static_cast<unsigned char>(own[i]);
        const auto before = static_cast<unsigned char>(i > 0 ? own[i - 1] : ' ');
        const auto after = static_cast<unsigned char>(i + 1 < own.size() ? own[i + 1] : ' ');
        const bool isCapital = std::isupper(letter) != 0;
        if (std::isalpha(letter) == 0 || (isCapital && std::islower(before) != 0) ||
            (isCapital && std::isupper(before) != 0 && std::islower(after) != 0)) {
            finish();
        }
        if (std::isalpha(letter) != 0) {
            word += static_cast<char>(std::tolower(letter));
        }
    }
    finish();
    return words;
}

/// Words in all of several names, of a rig or a figure.
std::set<std::string> sharedWords(const std::vector<Words>& names)
{
    std::map<std::string, std::size_t> in;
    for (const Words& words : names) {
        for (const std::string& word : std::set<std::string>(words.begin(), words.end())) {
            ++in[word];
        }
    }
    std::set<std::string> shared;
    for (const auto& [word, count] : in) {
        if (names.size() > 2 && count == names.size() && !roleWords().contains(word)) {
            shared.insert(word);
        }
    }
    return shared;
}

/// One of several roles in a name: "idle_walk" is no gait, "sit_idle" is sitting.
ClipRole stronger(ClipRole a, ClipRole b)
{
    const auto rank = [](ClipRole role) {
        return role == ClipRole::Sit ? 3 : isGait(role) ? 1 : role == ClipRole::Idle ? 2 : 0;
    };
    return rank(b) > rank(a) ? b : a;
}

NamedUse useOf(const Words& words, const std::set<std::string>& shared)
{
    NamedUse use;
    ClipRole weak = ClipRole::Other;
    bool isAction = false;
    bool saysMore = false;
    for (const std::string& word : words) {
        if (shared.contains(word)) {
            continue;
        }
        const auto role = roleWords().find(word);
        const auto maybe = weakWords().find(word);
        if (role != roleWords().end()) {
            use.role = stronger(use.role, role->second);
        } else if (isActionWord(word)) {
            isAction = true;
        } else if (maybe != weakWords().end() && !isNeutralWord(word)) {
            weak = maybe->second;
            saysMore = true;
        } else if (maybe != weakWords().end()) {
            weak = maybe->second;
        } else {
            saysMore = saysMore || !isNeutralWord(word);
        }
    }
    if (isAction) {
        return {NamedUse::Kind::Action, ClipRole::Other};
    }
    if (use.role != ClipRole::Other) {
        use.kind = saysMore ? NamedUse::Kind::Variant : NamedUse::Kind::Plain;
    } else if (weak != ClipRole::Other) {
        use = {NamedUse::Kind::Weak, weak};
    }
    return use;
}

} // namespace

std::vector<NamedUse> namedUses(const std::vector<std::string>& names)
{
    std::vector<Words> words;
    words.reserve(names.size());
    for (const std::string& name : names) {
        words.push_back(wordsOf(name));
    }
    const std::set<std::string> shared = sharedWords(words);
    std::vector<NamedUse> uses;
    uses.reserve(words.size());
    for (const Words& each : words) {
        uses.push_back(useOf(each, shared));
    }
    return uses;
}

} // namespace crowd::model::gltf

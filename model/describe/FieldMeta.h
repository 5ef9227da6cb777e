// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

/// The facts that describe anything that can be set: a member of settings (see Field.h), or a
/// property of an individual (see model/population/Properties.h). Data alone; lives as long as the
/// program.
namespace crowd::model {

/// What a value stands for, where its type does not say it: which control edits it, and what a
/// number or a text refers to.
enum class FieldRole : std::uint8_t {
    Plain,
    Angle,        ///< radians; degrees on screen
    Path,         ///< PathId; 0 and kNearestPath have meanings of their own
    Place,        ///< PlaceId
    Tag,          ///< bit of the tags column
    Slot,         ///< a slot's name; empty: all tintable ones
    Clip,         ///< a clip's name
    Event,        ///< an event's name
    ArtistNumber, ///< NumberId
    Template,     ///< TemplateId
    Point,        ///< glm::vec3 of the scene, metres
    Color,        ///< glm::vec3, sRGB 0..1
    WalkingClips, ///< of clips those that move over ground alone
    SeatNumbers,  ///< rows or wedges of seats
    Material,     ///< a name of a slot's materials; empty: any
    Group,        ///< GroupId; 0: none
    Part,         ///< a part's name; empty: all
    State,        ///< StateId
    Light,        ///< LightId
    Cue,          ///< CueId
    Feature,      ///< FeatureId; in lists with weights, the name of a value
    FeatureKind,  ///< the name of a kind of feature
    Relation,     ///< RelationKindId
    RelationKind, ///< the name of a kind of relation
    Individual,   ///< IndividualId; 0: nobody
    Space,        ///< glm::vec3 of the scene, metres, that need not lie on anything
    Target,       ///< a Space that something is turned to
    Opening,      ///< radians from edge to edge of a cone around the way to its Target
    Counted,      ///< a whole number that people count from 1 and the program from 0
    Sequence,     ///< whole numbers in an order that means something
    Camera,       ///< a camera's name; empty: none
    Stature       ///< a share of a template's own height; forms say what it comes to in metres
};

/// A member of an enumeration: `key` in scripts and files, `label` and `tip` on screen.
struct FieldChoice
{
    const char* key;
    const char* label;
    const char* tip = "";
    bool isOffered = true; ///< else shown only where it is what is chosen
};

/// Plain facts of one member. Numbers are in the unit that is stored; on screen they are multiplied
/// by `shownScale` and followed by `unit`.
struct FieldMeta
{
    const char* key = "";   ///< attribute of the Python class and member of JSON objects
    const char* label = ""; ///< on screen; empty: in no form
    const char* tip = "";
    const char* doc = ""; ///< for the manual and the stubs, English
    const char* unit = "";
    double low = 0.0; ///< legal range of numbers, of both ends of ranges and of weights
    double high = 1.0;
    double sliderLow = 0.0; ///< range of the control, as shown; both 0: the legal one
    double sliderHigh = 0.0;
    double step = 0.1; ///< as shown
    int decimals = 2;
    bool isLogarithmic = false;
    double shownScale = 1.0;
    FieldRole role = FieldRole::Plain;
    std::span<const FieldChoice> choices{}; ///< of enumerations, from 0 on; of bools: no and yes
    const char* section = "";               ///< heading of a form under which it and those after
                                            ///< it stand; empty: the same as before
    bool isBeside = false;                  ///< shown in one row with the one before
    bool isRemembered = true;               ///< by the next start of the editor
    /// What is shown instead of the lowest number, of no reference or of an empty text, where that
    /// has a meaning of its own; empty: it has none.
    const char* zero = "";
    bool isStored = true; ///< in files and scripts; see computed()
    bool isBrief = false; ///< a struct: files leave it out while it is as it begins
};

} // namespace crowd::model

// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::behavior {

/// Constants of the social force. Elliptical repulsion after Helbing and Molnár, "Social force
/// model for pedestrian dynamics" (1995), with the relative velocity of both; strengths are
/// accelerations (m/s²), lengths metres, times seconds.
struct ForceParameters
{
    float relaxationSeconds = 0.5F;   ///< to reach the desired velocity
    float strength = 20.0F;           ///< of repulsion between people
    float reach = 0.2F;               ///< its decay length
    float anticipationSeconds = 1.0F; ///< how far ahead the ellipse looks
    float leastAxis = 0.1F;           ///< of the ellipse, metres: head-on it would vanish
    float fromBehind = 0.5F;          ///< share of the repulsion by those behind one's back
    float range = 2.0F;               ///< people further away are not noticed
    float contact = 60.0F;            ///< per metre of two bodies' overlap
    float wallStrength = 10.0F;
    float wallReach = 0.2F;
    float wallContact = 200.0F;
    float topSpeed = 1.3F;    ///< times the preferred speed
    float slowingDown = 5.0F; ///< to that speed at most, m/s²: nobody can at once
    /// How much walkers slow down as it gets dense ahead, after Weidmann, "Transporttechnik der
    /// Fussgänger" (1993): 0 not at all, 1 as observed.
    float slowing = 1.0F;
    /// How much less somebody who comes straight towards one counts for that: nobody has to walk at
    /// his pace, the two pass each other. Two-way crowds are known to carry more people than
    /// one-way ones (Kretz et al., "Experimental study of pedestrian counterflow in a corridor",
    /// 2006).
    float oncoming = 0.9F;
    /// Shares of the repulsion against one's own way that a walker of that pace does not feel: the
    /// pace knows of the people already, and whoever aims at a door is not stopped by its posts.
    float easedPeople = 0.46F;
    float easedWalls = 0.75F;
    float jam = 5.5F; ///< people per square metre ahead among whom nobody presses on
    /// Two bodies closer than this share of the sum of their radii are pushed apart at once.
    float closest = 0.82F;
    bool plainInstructions = false; ///< only what every processor can do: slower, the same bits
};

} // namespace crowd::behavior

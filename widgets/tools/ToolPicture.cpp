// SPDX-License-Identifier: MIT
#include "widgets/tools/ToolPicture.h"

#include <algorithm>

namespace crowd::widgets {

namespace {

bool isSameGhost(const render::Ghost& a, const render::Ghost& b)
{
    return a.asset == b.asset && a.clip == b.clip && a.phase == b.phase &&
           a.position == b.position && a.headingRadians == b.headingRadians &&
           a.height == b.height && a.girth == b.girth && a.lift == b.lift && a.tints == b.tints &&
           a.materialChoices == b.materialChoices && a.parts == b.parts && a.alpha == b.alpha;
}

} // namespace

bool showsTheSameInScene(const ToolPicture& a, const ToolPicture& b)
{
    return a.hovered == b.hovered && std::equal(a.ghosts.begin(), a.ghosts.end(), b.ghosts.begin(),
                                                b.ghosts.end(), isSameGhost);
}

} // namespace crowd::widgets

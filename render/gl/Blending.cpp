// SPDX-License-Identifier: MIT
#include "render/gl/Blending.h"

#include <epoxy/gl.h>

namespace crowd::render {

void blendOver(bool isTransparent)
{
    if (isTransparent) {
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    } else {
        // The picture stays opaque whatever is blended over it.
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    }
}

void blendAdding()
{
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
}

void blendMultiplying()
{
    glBlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ZERO, GL_ONE);
}

} // namespace crowd::render

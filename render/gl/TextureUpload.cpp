// SPDX-License-Identifier: MIT
#include "render/gl/TextureUpload.h"

#include <algorithm>

#include <epoxy/gl.h>

namespace crowd::render {

namespace {

GLint wrapMode(model::Wrap wrap)
{
    switch (wrap) {
    case model::Wrap::Mirror:
        return GL_MIRRORED_REPEAT;
    case model::Wrap::Clamp:
        return GL_CLAMP_TO_EDGE;
    case model::Wrap::Repeat:
        break;
    }
    return GL_REPEAT;
}

/// With its mipmaps.
std::size_t bytesOf(int width, int height, std::size_t layers)
{
    return pixelBytes({width, height}, 4) * layers * 4 / 3;
}

void finish(GLenum target, const Sampling& sampling)
{
    glTexParameteri(target, GL_TEXTURE_WRAP_S, wrapMode(sampling.wrapU));
    glTexParameteri(target, GL_TEXTURE_WRAP_T, wrapMode(sampling.wrapV));
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, sampling.isNearest ? GL_NEAREST : GL_LINEAR);
    const GLint minify = sampling.isNearest       ? GL_NEAREST_MIPMAP_LINEAR
                         : sampling.isBetweenMips ? GL_LINEAR_MIPMAP_LINEAR
                                                  : GL_LINEAR_MIPMAP_NEAREST;
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minify);
    glGenerateMipmap(target);
}

GlTexture upload(const model::Image& image, GLint format, const Sampling& sampling)
{
    GlTexture texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    if (texture.take(bytesOf(image.width, image.height, 1))) {
        glTexImage2D(GL_TEXTURE_2D, 0, format, image.width, image.height, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, image.rgba.data());
        finish(GL_TEXTURE_2D, sampling);
    }
    return texture;
}

} // namespace

GlTexture uploadLayers(int width, int height, const std::vector<std::vector<std::uint8_t>>& layers,
                       const Sampling& sampling)
{
    GlTexture texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.name());
    if (!texture.take(bytesOf(width, height, layers.size()))) {
        return texture;
    }
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, width, height,
                 static_cast<GLsizei>(layers.size()), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(i), width, height, 1,
                        GL_RGBA, GL_UNSIGNED_BYTE, layers[i].data());
    }
    finish(GL_TEXTURE_2D_ARRAY, sampling);
    return texture;
}

GlTexture uploadImage(const model::Image& image, const Sampling& sampling)
{
    return upload(image, GL_SRGB8_ALPHA8, sampling);
}

GlTexture uploadValues(const model::Image& image, const Sampling& sampling)
{
    return upload(image, GL_RGBA8, sampling);
}

} // namespace crowd::render

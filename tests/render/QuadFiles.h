// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include <QtCore/QBuffer>
#include <QtGui/QImage>

#include "tests/model/GltfBuilder.h"

/// glTF files of one square that shows four colours, written in one way or another.
namespace crowd::testing {

using Json = GltfBuilder::Json;

/// Two by two: red, yellow, blue, white.
inline QImage fourColours()
{
    QImage picture(2, 2, QImage::Format_RGBA8888);
    picture.setPixelColor(0, 0, QColor(255, 0, 0));
    picture.setPixelColor(1, 0, QColor(255, 255, 0));
    picture.setPixelColor(0, 1, QColor(0, 0, 255));
    picture.setPixelColor(1, 1, QColor(255, 255, 255));
    return picture;
}

inline std::string dataUri(const QImage& picture, const char* format = "png")
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, format, 100)) {
        qFatal("cannot write %s", format);
    }
    return (QByteArray("data:image/") + format + ";base64," + bytes.toBase64()).toStdString();
}

/// Corners of a square from -1 to 1 that faces +Z: top left, bottom left, bottom right, top right.
inline const std::vector<float> kCorners{-1, 1, 0, -1, -1, 0, 1, -1, 0, 1, 1, 0};
inline const std::vector<float> kCornerUv{0, 0, 0, 1, 1, 1, 1, 0};

inline Json& primitiveOf(GltfBuilder& builder)
{
    return builder.root["meshes"][0]["primitives"][0];
}

inline Json& attributesOf(GltfBuilder& builder)
{
    return primitiveOf(builder)["attributes"];
}

/// A material with a picture whose texels are told apart; its index.
inline int addPicture(GltfBuilder& builder, const QImage& picture, const Json& sampler = {})
{
    Json nearest = {{"magFilter", 9728}};
    nearest.update(sampler.is_object() ? sampler : Json::object());
    const int texture = static_cast<int>(builder.root["textures"].size());
    builder.add("images", {{"uri", dataUri(picture)}});
    builder.add("samplers", nearest);
    builder.add("textures", {{"source", texture}, {"sampler", texture}});
    return builder.add("materials",
                       {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
}

/// The square with the picture of four colours.
inline GltfBuilder quad(const std::vector<float>& corners = kCorners,
                        const std::vector<float>& uv = kCornerUv)
{
    GltfBuilder builder;
    const int positions = builder.accessor<float>(corners, "VEC3");
    const int coordinates = builder.accessor<float>(uv, "VEC2");
    const int indices = builder.accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
    const int material = addPicture(builder, fourColours());
    builder.add("meshes",
                {{"primitives",
                  {{{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", coordinates}}},
                    {"indices", indices},
                    {"material", material}}}}});
    builder.add("nodes", {{"mesh", 0}});
    builder.add("scenes", {{"nodes", {0}}});
    builder.root["scene"] = 0;
    return builder;
}

} // namespace crowd::testing

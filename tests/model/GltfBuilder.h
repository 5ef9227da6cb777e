// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <QtCore/QByteArray>
#include <QtCore/QFile>

/// Small glTF files for tests: JSON that a test can bend, and one binary chunk.
class GltfBuilder
{
public:
    using Json = nlohmann::json;

    Json root = {{"asset", {{"version", "2.0"}}}};
    std::vector<std::uint8_t> bytes;

    /// Appends values as a view of their own, aligned to four bytes; its index.
    template<class T>
    int view(const std::vector<T>& values)
    {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        const std::size_t offset = bytes.size();
        bytes.resize(offset + values.size() * sizeof(T));
        if (!values.empty()) {
            std::memcpy(bytes.data() + offset, values.data(), values.size() * sizeof(T));
        }
        root["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}});
        return static_cast<int>(root["bufferViews"].size()) - 1;
    }

    /// An accessor over values of its own.
    template<class T>
    int accessor(const std::vector<T>& values, const char* type)
    {
        return accessorOf(view(values), componentType<T>(), values.size() / components(type), type);
    }

    int accessorOf(int view, int componentType, std::size_t count, const char* type)
    {
        Json accessor{{"componentType", componentType}, {"count", count}, {"type", type}};
        if (view >= 0) {
            accessor["bufferView"] = view;
        }
        root["accessors"].push_back(std::move(accessor));
        return static_cast<int>(root["accessors"].size()) - 1;
    }

    int add(const char* array, Json item)
    {
        root[array].push_back(std::move(item));
        return static_cast<int>(root[array].size()) - 1;
    }

    /// A triangle in the XY plane with one node and one scene.
    static GltfBuilder triangle()
    {
        GltfBuilder builder;
        const int positions = builder.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
        const int indices = builder.accessor<std::uint16_t>({0, 1, 2}, "SCALAR");
        builder.add(
            "meshes",
            {{"primitives", {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}}}});
        builder.add("nodes", {{"mesh", 0}});
        builder.add("scenes", {{"nodes", {0}}});
        builder.root["scene"] = 0;
        return builder;
    }

    [[nodiscard]] Json withBuffer() const
    {
        Json json = root;
        if (!bytes.empty() && !json.contains("buffers")) {
            json["buffers"] = {{{"byteLength", bytes.size()}}};
        }
        return json;
    }

    [[nodiscard]] QByteArray glb() const { return glb(withBuffer().dump()); }

    [[nodiscard]] QByteArray glb(std::string json) const
    {
        json.resize((json.size() + 3) / 4 * 4, ' ');
        std::vector<std::uint8_t> binary = bytes;
        binary.resize((binary.size() + 3) / 4 * 4);
        QByteArray out("glTF");
        const auto word = [&out](std::size_t value) {
            const auto number = static_cast<std::uint32_t>(value);
            out.append(reinterpret_cast<const char*>(&number), 4);
        };
        word(2);
        word(12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size()));
        word(json.size());
        word(0x4E4F534A);
        out.append(json.data(), static_cast<qsizetype>(json.size()));
        if (!binary.empty()) {
            word(binary.size());
            word(0x004E4942);
            out.append(reinterpret_cast<const char*>(binary.data()),
                       static_cast<qsizetype>(binary.size()));
        }
        return out;
    }

    /// A .gltf with the buffer as a data: URI.
    [[nodiscard]] QByteArray embedded() const
    {
        Json json = withBuffer();
        const QByteArray base64 = QByteArray(reinterpret_cast<const char*>(bytes.data()),
                                             static_cast<qsizetype>(bytes.size()))
                                      .toBase64();
        json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.toStdString();
        return QByteArray::fromStdString(json.dump());
    }

private:
    template<class T>
    static constexpr int componentType()
    {
        if constexpr (std::is_same_v<T, float>) {
            return 5126;
        } else if constexpr (sizeof(T) == 4) {
            return 5125;
        } else if constexpr (sizeof(T) == 2) {
            return std::is_signed_v<T> ? 5122 : 5123;
        } else {
            return std::is_signed_v<T> ? 5120 : 5121;
        }
    }

    static std::size_t components(const std::string& type)
    {
        return type == "SCALAR" ? 1
               : type == "VEC2" ? 2
               : type == "VEC3" ? 3
               : type == "VEC4" ? 4
                                : 16;
    }
};

/// Writes a file; its path in UTF-8.
inline std::string writeFile(const QString& path, const QByteArray& content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) {
        qFatal("cannot write %s", qPrintable(path));
    }
    return path.toStdString();
}

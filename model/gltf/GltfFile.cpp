// SPDX-License-Identifier: MIT
#include "model/gltf/GltfFile.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <tiny_gltf.h>

#include <QtCore/QFileInfo>
#include <QtCore/QString>

#include "model/gltf/GltfContainer.h"
#include "model/gltf/GltfDraco.h"
#include "model/gltf/GltfInstances.h"
#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfMeshopt.h"
#include "model/gltf/GltfPointers.h"
#include "model/gltf/GltfValidate.h"

namespace crowd::model::gltf {

namespace {

/// What tinygltf reads through its callbacks instead of the disk: "b3" is buffer 3.
struct Memory
{
    std::vector<Bytes> buffers;

    Bytes* find(const std::string& name)
    {
        std::size_t number = 0;
        const char* end = name.data() + name.size();
        if (name.size() < 2 || std::from_chars(name.data() + 1, end, number).ptr != end) {
            return nullptr;
        }
        return number < buffers.size() ? &buffers[number] : nullptr;
    }
};

bool memoryExists(const std::string& name, void* user)
{
    return static_cast<Memory*>(user)->find(name) != nullptr;
}

std::string keepName(const std::string& name, void* /*user*/)
{
    return name;
}

bool takeMemory(std::vector<unsigned char>* out, std::string* error, const std::string& name,
                void* user)
{
    Bytes* bytes = static_cast<Memory*>(user)->find(name);
    if (bytes == nullptr) {
        *error += name + " is not in memory";
        return false;
    }
    *out = std::move(*bytes);
    return true;
}

bool writeNothing(std::string* /*error*/, const std::string& /*name*/,
                  const std::vector<unsigned char>& /*bytes*/, void* /*user*/)
{
    return false;
}

/// What a buffer's URI refers to.
Result<Bytes> readBufferUri(const Json& buffer, const std::string& where, const std::string& folder)
{
    Result<Bytes> read = readUri(textOf(buffer, "uri"), folder);
    if (read) {
        return read;
    }
    const bool isMissing = read.error().message.find("no such file") != std::string::npos;
    return Error{
        isMissing
            ? QT_TRANSLATE_NOOP(
                  "Messages",
                  "%1.uri: %2; put that file there, or export the file as .glb, which holds all")
            : QT_TRANSLATE_NOOP("Messages", "%1.uri: %2"),
        where, read.error().said};
}

/// The bytes of one buffer; none for one that only stands in for compressed data.
Result<Bytes> readBuffer(const Json& buffer, std::size_t index, Container& container,
                         const std::string& folder)
{
    const std::string where = place("buffers", index);
    const std::uint64_t length = wholeOr(buffer, "byteLength", 0);
    Result<Bytes> read = Error{
        QT_TRANSLATE_NOOP("Messages", "%1 has no uri, and the file has no binary chunk for it"),
        where};
    if (buffer.contains("uri")) {
        read = readBufferUri(buffer, where, folder);
    } else if (index == 0 && container.hasBinary) {
        read = std::move(container.binary);
    }
    if (read && read.value().size() < length) {
        read =
            Error{QT_TRANSLATE_NOOP("Messages", "%1 should have %2 bytes, but only %3 are there"),
                  where, length, read.value().size()};
    }
    if (!read && isFallback(buffer)) {
        return Bytes();
    }
    if (read) {
        read.value().resize(length);
    }
    return read;
}

/// Reads the buffers into memory.
Result<void> readBuffers(const Json& root, Container& container, const std::string& folder,
                         Memory& memory)
{
    std::uint64_t total = 0;
    const std::size_t count = countOf(root, "buffers");
    for (std::size_t i = 0; i < count; ++i) {
        const Json& buffer = root.at("buffers").at(i);
        total += wholeOr(buffer, "byteLength", 0);
        if (total > kMaxBufferBytes) {
            return Error{
                QT_TRANSLATE_NOOP("Messages", "%1: the buffers are larger than 1 GiB together"),
                place("buffers", i)};
        }
        Result<Bytes> bytes = readBuffer(buffer, i, container, folder);
        if (!bytes) {
            return bytes.error();
        }
        memory.buffers.push_back(std::move(bytes).value());
    }
    return {};
}

/// tinygltf never sees the images: nothing is left for it to decode or look up.
std::vector<ImageSource> findImages(const Json& root)
{
    std::vector<ImageSource> sources;
    for (std::size_t i = 0; i < countOf(root, "images"); ++i) {
        const Json& image = root.at("images").at(i);
        ImageSource source{textOf(image, "name"), textOf(image, "uri")};
        if (source.uri.empty() && image.contains("bufferView")) {
            const Json& view = root.at("bufferViews").at(wholeOr(image, "bufferView", 0));
            source.buffer = static_cast<int>(wholeOr(view, "buffer", 0));
            source.offset = wholeOr(view, "byteOffset", 0);
            source.length = wholeOr(view, "byteLength", 0);
        }
        sources.push_back(std::move(source));
    }
    return sources;
}

std::vector<Json*> sparseAccessors(Json& root)
{
    std::vector<Json*> found;
    for (std::size_t i = 0; i < countOf(root, "accessors"); ++i) {
        Json& accessor = root["accessors"][i];
        if (accessor.contains("sparse")) {
            found.push_back(&accessor);
        }
    }
    return found;
}

/// Only what we read reaches tinygltf; buffers have at least the byte that it insists on.
Json plainRoot(Json& root, Memory& memory)
{
    constexpr std::array kKept{"accessors",  "animations", "asset",  "bufferViews", "buffers",
                               "extensions", "materials",  "meshes", "nodes",       "samplers",
                               "scene",      "scenes",     "skins",  "textures",    "extras"};
    Json plain = Json::object();
    for (const char* key : kKept) {
        if (root.contains(key)) {
            plain[key] = std::move(root[key]);
        }
    }
    if (plain.contains("nodes")) {
        for (Json& node : plain["nodes"]) {
            node.erase("camera");
        }
    }
    if (plain.contains("extensions")) {
        plain["extensions"].erase("KHR_lights_punctual");
    }
    for (Json* accessor : sparseAccessors(plain)) {
        // tinygltf wants what the specification lets out.
        for (const char* part : {"indices", "values"}) {
            Json& of = (*accessor)["sparse"][part];
            of["byteOffset"] = wholeOr(of, "byteOffset", 0);
        }
    }
    for (std::size_t i = 0; i < memory.buffers.size(); ++i) {
        memory.buffers[i].resize(std::max<std::size_t>(1, memory.buffers[i].size()));
        plain["buffers"][i] =
            Json{{"byteLength", memory.buffers[i].size()}, {"uri", "b" + std::to_string(i)}};
    }
    return plain;
}

Result<void> parse(const Json& plain, Memory& memory, tinygltf::Model& model)
{
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks({memoryExists, keepName, takeMemory, writeNothing, &memory});
    std::string problem;
    std::string warning;
    try {
        const std::string text = plain.dump();
        if (loader.LoadASCIIFromString(&model, &problem, &warning, text.data(),
                                       static_cast<unsigned int>(text.size()), "",
                                       tinygltf::NO_REQUIRE)) {
            return {};
        }
    } catch (const std::exception& thrown) {
        problem += thrown.what();
    }
    std::replace(problem.begin(), problem.end(), '\n', ' ');
    return Error{QT_TRANSLATE_NOOP("Messages", "the file cannot be read: %1"), problem};
}

/// Extensions that may change what is seen more than the shine of a surface, and are not read.
void addUnreadExtensions(const Json& root, std::vector<Message>& warnings)
{
    constexpr std::array<std::pair<std::string_view, const char*>, 1> kUnread{
        {{"KHR_node_visibility", QT_TRANSLATE_NOOP("Messages", "what it hides is drawn")}}};
    const Json& used = member(root, "extensionsUsed");
    for (std::size_t i = 0; used.is_array() && i < used.size(); ++i) {
        for (const auto& [name, effect] : kUnread) {
            if (used[i].is_string() && used[i] == name) {
                warnings.emplace_back(QT_TRANSLATE_NOOP("Messages", "%1 is not read: %2."), name,
                                      Message(effect));
            }
        }
    }
}

Result<GltfFile> readChecked(const std::string& path)
{
    const QFileInfo info(QString::fromStdString(path));
    Result<Container> container = readContainer(path);
    if (!container) {
        return container.error();
    }
    Result<Json> parsed = parseJson(container.value().json);
    if (!parsed) {
        return parsed.error();
    }
    Json& root = parsed.value();
    if (const Result<void> structure = validateStructure(root); !structure) {
        return structure.error();
    }
    GltfFile file;
    file.name = info.completeBaseName().toStdString();
    file.folder = info.path().toStdString();
    file.warnings = container.value().warnings;
    Memory memory;
    if (const Result<void> read = readBuffers(root, container.value(), file.folder, memory);
        !read) {
        return read.error();
    }
    if (const Result<void> decoded = decodeMeshopt(root, memory.buffers); !decoded) {
        return decoded.error();
    }
    std::vector<std::size_t> sizes;
    for (const Bytes& buffer : memory.buffers) {
        sizes.push_back(buffer.size());
    }
    if (const Result<void> layout = validateLayout(root, sizes); !layout) {
        return layout.error();
    }
    if (const Result<void> decoded = decodeDraco(root, memory.buffers); !decoded) {
        return decoded.error();
    }
    file.images = findImages(root);
    resolveAnimationPointers(root, file.warnings);
    const Json plain = plainRoot(root, memory);
    if (const Result<void> done = parse(plain, memory, *file.model); !done) {
        return done.error();
    }
    if (const Result<void> expanded = expandInstances(*file.model); !expanded) {
        return expanded.error();
    }
    addUnreadExtensions(root, file.warnings);
    return file;
}

} // namespace

GltfFile::GltfFile() : model(std::make_unique<tinygltf::Model>()) {}
GltfFile::~GltfFile() = default;
GltfFile::GltfFile(GltfFile&&) noexcept = default;
GltfFile& GltfFile::operator=(GltfFile&&) noexcept = default;

namespace {

/// A message of file and problem, with the usual way out unless the problem tells one.
const char* withWayOut(const std::string& problem)
{
    const auto says = [&](std::string_view text) { return problem.find(text) != problem.npos; };
    if (says("onvert it") || says("export the file")) {
        return QT_TRANSLATE_NOOP("Messages", "%1: %2.");
    }
    if (says("no such file") || says("not a plain file") || says("cannot be opened")) {
        return QT_TRANSLATE_NOOP("Messages", "%1: %2. Check the name, the folder and its rights.");
    }
    return QT_TRANSLATE_NOOP(
        "Messages", "%1: %2. Export it again as glTF 2.0 (.glb) from the program it was made in.");
}

} // namespace

Error fileError(const std::string& path, const Message& problem)
{
    const std::string file = QFileInfo(QString::fromStdString(path)).fileName().toStdString();
    return Error{withWayOut(problem.english()), file.empty() ? path : file, problem};
}

Result<GltfFile> readGltf(const std::string& path)
{
    try {
        Result<GltfFile> file = readChecked(path);
        return file ? std::move(file) : Result<GltfFile>(fileError(path, file.error().said));
    } catch (const std::bad_alloc&) {
        return fileError(path, QT_TRANSLATE_NOOP("Messages", "it needs more memory than there is"));
    } catch (const std::exception& thrown) {
        return fileError(path,
                         {QT_TRANSLATE_NOOP("Messages", "it cannot be read: %1"), thrown.what()});
    }
}

} // namespace crowd::model::gltf

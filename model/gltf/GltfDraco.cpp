// SPDX-License-Identifier: MIT
#include "model/gltf/GltfDraco.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <span>

#include "model/gltf/ApartProcess.h"
#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfValidate.h"
#include "model/unpack/DracoWire.h"

namespace crowd::model::gltf {

namespace {

using unpack::Outcome;

constexpr const char* kDracoName = "KHR_draco_mesh_compression";
constexpr std::uint32_t kUnsignedInt = 5125;

/// An attribute to be unpacked, and the accessor that says as what.
struct Wanted
{
    std::string name;
    unpack::AttributeHead as;
    std::size_t accessor = 0;
};

/// One compressed mesh, and the primitives that use it in the same way.
struct Job
{
    std::string where;
    std::span<const std::uint8_t> data;
    std::uint64_t maxPoints = kMaxVertices;
    std::uint64_t maxCorners = kMaxCorners;
    std::vector<Wanted> attributes;
    std::vector<Json*> primitives;
};

template<class T>
void append(Bytes& out, const T& value)
{
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&value);
    out.insert(out.end(), bytes, bytes + sizeof(T));
}

Bytes requestOf(const std::vector<Job>& jobs)
{
    Bytes out;
    append(out, unpack::kMagic);
    append(out, static_cast<std::uint32_t>(jobs.size()));
    for (const Job& job : jobs) {
        append(out, unpack::JobHead{static_cast<std::uint32_t>(job.data.size()),
                                    static_cast<std::uint32_t>(job.maxPoints),
                                    static_cast<std::uint32_t>(job.maxCorners),
                                    static_cast<std::uint32_t>(job.attributes.size())});
        for (const Wanted& wanted : job.attributes) {
            append(out, wanted.as);
        }
        out.insert(out.end(), job.data.begin(), job.data.end());
    }
    return out;
}

/// Puts what came back into the file.
class Installer
{
public:
    Installer(Json& root, std::vector<Bytes>& buffers, const Bytes& from)
        : m_root(root), m_buffers(buffers), m_from(from)
    {
    }

    Result<void> install(const Job& job)
    {
        unpack::MeshHead head;
        if (m_from.size() - m_at < sizeof(head)) {
            return Error{QT_TRANSLATE_NOOP("Messages", "it is damaged")};
        }
        std::memcpy(&head, m_from.data() + m_at, sizeof(head));
        m_at += sizeof(head);
        if (head.outcome != Outcome::Fine) {
            return complaint(head, job);
        }
        return put(head, job) ? Result<void>()
                              : Error{QT_TRANSLATE_NOOP("Messages", "it is damaged")};
    }

private:
    static Error complaint(const unpack::MeshHead& head, const Job& job)
    {
        switch (head.outcome) {
        case Outcome::TooManyPoints:
            return Error{
                QT_TRANSLATE_NOOP("Messages", "it has %1 vertices, but its accessors say %2"),
                head.points, job.maxPoints};
        case Outcome::TooManyCorners:
            return Error{
                QT_TRANSLATE_NOOP("Messages", "it has %1 indices, but its accessor says %2"),
                head.corners, job.maxCorners};
        case Outcome::NoAttribute:
            return Error{QT_TRANSLATE_NOOP(
                "Messages",
                "it lacks an attribute that the file wants of it, or has it with another "
                "number of components")};
        default:
            return Error{QT_TRANSLATE_NOOP("Messages", "it is damaged")};
        }
    }

    bool put(const unpack::MeshHead& head, const Job& job)
    {
        const Json indices = {
            {"componentType", kUnsignedInt}, {"count", head.corners}, {"type", "SCALAR"}};
        const std::size_t indexAccessor = add(indices, std::uint64_t{4} * head.corners);
        std::vector<std::size_t> accessors;
        for (const Wanted& wanted : job.attributes) {
            Json accessor = m_root["accessors"][wanted.accessor];
            accessor["count"] = head.points;
            accessor.erase("min");
            accessor.erase("max");
            const std::uint64_t element =
                componentBytes(wanted.as.componentType) * wanted.as.components;
            accessors.push_back(add(std::move(accessor), element * head.points));
        }
        for (Json* primitive : job.primitives) {
            (*primitive)["mode"] = 4;
            (*primitive)["indices"] = indexAccessor;
            (*primitive)["extensions"].erase(kDracoName);
            for (std::size_t i = 0; i < accessors.size(); ++i) {
                (*primitive)["attributes"][job.attributes[i].name] = accessors[i];
            }
        }
        return m_isWhole;
    }

    /// The next bytes as a buffer with a view and an accessor; the accessor's index.
    std::size_t add(Json accessor, std::uint64_t bytes)
    {
        m_isWhole = m_isWhole && m_from.size() - m_at >= bytes;
        const std::size_t there = m_isWhole ? bytes : 0;
        const auto first = m_from.begin() + static_cast<std::ptrdiff_t>(m_at);
        m_buffers.emplace_back(first, first + static_cast<std::ptrdiff_t>(there));
        m_at += there;
        m_root["bufferViews"].push_back(
            {{"buffer", m_buffers.size() - 1}, {"byteOffset", 0}, {"byteLength", there}});
        accessor["bufferView"] = m_root["bufferViews"].size() - 1;
        accessor["byteOffset"] = 0;
        m_root["accessors"].push_back(std::move(accessor));
        return m_root["accessors"].size() - 1;
    }

    Json& m_root;
    std::vector<Bytes>& m_buffers;
    const Bytes& m_from;
    std::size_t m_at = 0;
    bool m_isWhole = true;
};

/// Finds the compressed primitives and what they want.
class DracoCollector
{
public:
    DracoCollector(Json& root, const std::vector<Bytes>& buffers) : m_root(root), m_buffers(buffers)
    {
    }

    Result<std::vector<Job>> run()
    {
        for (std::size_t m = 0; m < countOf(m_root, "meshes"); ++m) {
            Json& mesh = m_root["meshes"][m];
            for (std::size_t p = 0; p < countOf(mesh, "primitives"); ++p) {
                Json& primitive = mesh["primitives"][p];
                const std::string where =
                    place("meshes", m) + "." + place("primitives", p) + ".extensions." + kDracoName;
                if (member(member(primitive, "extensions"), kDracoName).is_object() &&
                    !hasPlainData(primitive) && !add(primitive, where)) {
                    return Error{m_problem};
                }
            }
        }
        return std::move(m_jobs);
    }

private:
    template<class... Arguments>
    bool fail(const char* id, const Arguments&... arguments)
    {
        m_problem = Message(id, arguments...);
        return false;
    }

    const Json& accessor(std::size_t index) const { return m_root.at("accessors").at(index); }

    bool hasPlainData(const Json& primitive) const
    {
        const Json& attributes = member(primitive, "attributes");
        if (!attributes.contains("POSITION")) {
            return true; // nothing to draw
        }
        return hasData(attributes, "POSITION") &&
               (!primitive.contains("indices") || hasData(primitive, "indices"));
    }

    bool hasData(const Json& owner, const char* key) const
    {
        const Json& plain = accessor(wholeOr(owner, key, 0));
        return plain.contains("bufferView") || plain.contains("sparse");
    }

    bool add(Json& primitive, const std::string& where)
    {
        const std::string key = member(member(primitive, "extensions"), kDracoName).dump() +
                                member(primitive, "attributes").dump() +
                                member(primitive, "indices").dump();
        const auto [known, isNew] = m_known.try_emplace(key, m_jobs.size());
        if (!isNew) {
            m_jobs[known->second].primitives.push_back(&primitive);
            return true;
        }
        Job job;
        job.where = where;
        job.primitives.push_back(&primitive);
        if (!findData(member(member(primitive, "extensions"), kDracoName), job) ||
            !findAttributes(primitive, job)) {
            return false;
        }
        if (primitive.contains("indices")) {
            const Json& indices = accessor(wholeOr(primitive, "indices", 0));
            job.maxCorners = std::min(job.maxCorners, wholeOr(indices, "count", 0));
        }
        m_jobs.push_back(std::move(job));
        return true;
    }

    bool findData(const Json& extension, Job& job)
    {
        const std::uint64_t view = wholeOr(extension, "bufferView", ~std::uint64_t{0});
        if (view >= countOf(m_root, "bufferViews")) {
            return fail(
                QT_TRANSLATE_NOOP("Messages", "%1 is not the index of one of the file's %2"),
                job.where + ".bufferView", "bufferViews");
        }
        const Json& from = m_root.at("bufferViews").at(view);
        job.data = std::span(m_buffers[wholeOr(from, "buffer", 0)])
                       .subspan(wholeOr(from, "byteOffset", 0), wholeOr(from, "byteLength", 0));
        return true;
    }

    bool findAttributes(const Json& primitive, Job& job)
    {
        const Json& attributes = member(primitive, "attributes");
        const Json& ids = member(member(member(primitive, "extensions"), kDracoName), "attributes");
        if (!ids.is_object() || !ids.contains("POSITION")) {
            return fail(QT_TRANSLATE_NOOP("Messages", "%1 has no POSITION"),
                        job.where + ".attributes");
        }
        for (const auto& [name, id] : ids.items()) {
            if (!attributes.contains(name)) {
                continue;
            }
            Wanted wanted{name, {}, wholeOr(attributes, name.c_str(), 0)};
            const Json& as = accessor(wanted.accessor);
            const std::uint64_t number = asWhole(id).value_or(~std::uint64_t{0});
            if (number > 0xFFFFFFFFU || textOf(as, "type").starts_with("MAT")) {
                return fail(QT_TRANSLATE_NOOP("Messages", "%1 is nothing that a mesh has"),
                            job.where + ".attributes." + name);
            }
            wanted.as = {static_cast<std::uint32_t>(number),
                         static_cast<std::uint32_t>(wholeOr(as, "componentType", 0)),
                         static_cast<std::uint32_t>(componentCount(textOf(as, "type")))};
            job.maxPoints = std::min(job.maxPoints, wholeOr(as, "count", 0));
            job.attributes.push_back(std::move(wanted));
        }
        return true;
    }

    Json& m_root;
    const std::vector<Bytes>& m_buffers;
    std::vector<Job> m_jobs;
    std::map<std::string, std::size_t> m_known;
    Message m_problem;
};

/// Some seconds even for little, more for more.
ApartLimits limitsFor(const std::vector<Job>& jobs)
{
    ApartLimits limits{0, 10'000};
    std::uint64_t packed = 0;
    for (const Job& job : jobs) {
        packed += job.data.size();
        limits.outputBytes += sizeof(unpack::MeshHead) + job.maxCorners * 4;
        for (const Wanted& wanted : job.attributes) {
            limits.outputBytes +=
                job.maxPoints * componentBytes(wanted.as.componentType) * wanted.as.components;
        }
    }
    limits.outputBytes = std::min(limits.outputBytes, kMaxBufferBytes);
    limits.milliseconds += static_cast<int>(std::min<std::uint64_t>(packed >> 10U, 50'000));
    return limits;
}

Error unreadable(const Job& job, const Message& why)
{
    return Error{QT_TRANSLATE_NOOP("Messages", "%1: the compressed mesh cannot be read: %2"),
                 job.where, why};
}

} // namespace

Result<void> decodeDraco(Json& root, std::vector<Bytes>& buffers)
{
    Result<std::vector<Job>> found = DracoCollector(root, buffers).run();
    if (!found) {
        return found.error();
    }
    const std::vector<Job> jobs = std::move(found).value();
    if (jobs.empty()) {
        return {};
    }
    const std::string program = besideProgram(unpack::kProgram);
    if (program.empty()) {
        return unreadable(
            jobs.front(),
            {QT_TRANSLATE_NOOP("Messages", "the program %1, which belongs beside crowdbrush, is "
                                           "not there; export the file without Draco compression"),
             unpack::kProgram});
    }
    const Result<Bytes> bytes = runApart(program, requestOf(jobs), limitsFor(jobs));
    if (!bytes) {
        return unreadable(jobs.front(), bytes.error().said);
    }
    Installer installer(root, buffers, bytes.value());
    for (const Job& job : jobs) {
        if (const Result<void> installed = installer.install(job); !installed) {
            return unreadable(job, installed.error().said);
        }
    }
    return {};
}

} // namespace crowd::model::gltf

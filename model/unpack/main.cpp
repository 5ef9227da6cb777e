// SPDX-License-Identifier: MIT
// crowdbrush-unpack: decodes Draco's compressed meshes for the editor. libdraco reads past its
// buffers and asks for absurd amounts of memory when the data is damaged, so it lives in a program
// of its own, where that ends nothing but the import of one file. See DracoWire.h.

#include <sys/resource.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include <draco/compression/decode.h>

#include "model/unpack/DracoWire.h"

namespace crowd::model::unpack {

namespace {

constexpr rlim_t kMemoryBytes = rlim_t{3} << 30U;
constexpr rlim_t kSeconds = 60;

struct Job
{
    JobHead head;
    std::vector<AttributeHead> attributes;
    std::vector<char> bytes;
};

void limit(__rlimit_resource resource, rlim_t most)
{
    const rlimit both{most, most};
    (void)setrlimit(resource, &both);
}

void limitMyself()
{
#ifndef CROWD_SANITIZED // a sanitizer reserves terabytes
    limit(RLIMIT_AS, kMemoryBytes);
#endif
    limit(RLIMIT_CPU, kSeconds);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
}

template<class T>
bool read(T* values, std::size_t count)
{
    return std::fread(values, sizeof(T), count, stdin) == count;
}

template<class T>
bool write(const T* values, std::size_t count)
{
    return std::fwrite(values, sizeof(T), count, stdout) == count;
}

bool readJob(Job& job)
{
    if (!read(&job.head, 1)) {
        return false;
    }
    job.attributes.resize(job.head.attributes);
    job.bytes.resize(job.head.bytes);
    return read(job.attributes.data(), job.attributes.size()) &&
           read(job.bytes.data(), job.bytes.size());
}

template<class T>
bool convert(const draco::PointAttribute& from, std::uint32_t points, std::uint32_t components,
             std::vector<char>& out)
{
    if (!from.is_mapping_identity() && from.indices_map_size() < points) {
        return false;
    }
    for (std::uint32_t point = 0; point < points; ++point) {
        const draco::AttributeValueIndex at = from.mapped_index(draco::PointIndex(point));
        std::array<T, 4> values{};
        if (at.value() >= from.size() ||
            !from.ConvertValue<T>(at, static_cast<std::int8_t>(components), values.data())) {
            return false;
        }
        const char* bytes = reinterpret_cast<const char*>(values.data());
        out.insert(out.end(), bytes, bytes + components * sizeof(T));
    }
    return true;
}

bool convert(const draco::PointAttribute& from, std::uint32_t points, const AttributeHead& as,
             std::vector<char>& out)
{
    switch (as.componentType) {
    case 5120:
        return convert<std::int8_t>(from, points, as.components, out);
    case 5121:
        return convert<std::uint8_t>(from, points, as.components, out);
    case 5122:
        return convert<std::int16_t>(from, points, as.components, out);
    case 5123:
        return convert<std::uint16_t>(from, points, as.components, out);
    case 5125:
        return convert<std::uint32_t>(from, points, as.components, out);
    default:
        return convert<float>(from, points, as.components, out);
    }
}

Outcome judge(const draco::Mesh& mesh, const Job& job, std::vector<char>& values)
{
    if (mesh.num_points() > job.head.maxPoints) {
        return Outcome::TooManyPoints;
    }
    if (std::uint64_t{mesh.num_faces()} * 3 > job.head.maxCorners) {
        return Outcome::TooManyCorners;
    }
    for (const AttributeHead& as : job.attributes) {
        const draco::PointAttribute* from = mesh.GetAttributeByUniqueId(as.id);
        if (from == nullptr || from->num_components() != as.components) {
            return Outcome::NoAttribute;
        }
        if (!convert(*from, mesh.num_points(), as, values)) {
            return Outcome::Damaged;
        }
    }
    return mesh.num_points() == 0 ? Outcome::Damaged : Outcome::Fine;
}

/// False when there is no going on: what was told is the last.
bool answer(const Job& job)
{
    draco::DecoderBuffer buffer;
    buffer.Init(job.bytes.data(), job.bytes.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    MeshHead head;
    if (!decoded.ok()) {
        (void)write(&head, 1);
        return false;
    }
    const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
    std::vector<char> values;
    head = {judge(*mesh, job, values), mesh->num_points(), mesh->num_faces() * 3};
    if (!write(&head, 1) || head.outcome != Outcome::Fine) {
        return false;
    }
    for (std::uint32_t i = 0; i < mesh->num_faces(); ++i) {
        const draco::Mesh::Face& face = mesh->face(draco::FaceIndex(i));
        const std::array corners{face[0].value(), face[1].value(), face[2].value()};
        if (!write(corners.data(), corners.size())) {
            return false;
        }
    }
    return write(values.data(), values.size());
}

/// Whether the request could be read.
bool run()
{
    std::array<std::uint32_t, 2> head{};
    if (!read(head.data(), head.size()) || head[0] != kMagic) {
        return false;
    }
    for (std::uint32_t i = 0; i < head[1]; ++i) {
        Job job;
        if (!readJob(job)) {
            return false;
        }
        if (!answer(job)) {
            break;
        }
    }
    return true;
}

} // namespace

} // namespace crowd::model::unpack

int main()
{
    crowd::model::unpack::limitMyself();
    bool isDone = false;
    try {
        isDone = crowd::model::unpack::run();
    } catch (const std::exception& problem) {
        (void)std::fputs(problem.what(), stderr);
    }
    if (!isDone) {
        (void)std::fputs("crowdbrush-unpack serves crowdbrush and has no use by itself.\n", stderr);
    }
    std::fflush(stdout);
    std::_Exit(isDone ? 0 : 2);
}

// SPDX-License-Identifier: MIT
#include "model/gltf/GltfPrimitives.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <tiny_gltf.h>

#include "model/gltf/GltfAccessors.h"
#include "model/gltf/GltfLimits.h"

namespace crowd::model::gltf {

namespace {

constexpr int kMaxInfluenceSets = 4;
constexpr const char* kWrongType =
    QT_TRANSLATE_NOOP("Messages", "%1 has the wrong type of accessor");

bool isUnsigned(int componentType)
{
    return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

class Decoder
{
public:
    Decoder(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
            const PrimitiveRequest& request)
        : m_model(model), m_primitive(primitive), m_request(request)
    {
    }

    Result<PrimitiveData> run()
    {
        if (checkShapes() && readPositions() && readShading() && readInfluences() &&
            readIndices()) {
            return std::move(m_data);
        }
        return Error{m_problem};
    }

private:
    /// A message whose %1 is the place: the primitive, or `part` of it.
    template<class... Arguments>
    bool fail(const std::string& part, const char* id, const Arguments&... arguments)
    {
        m_problem = Message(id, m_request.place + part, arguments...);
        return false;
    }

    int attribute(const std::string& name) const
    {
        const auto found = m_primitive.attributes.find(name);
        return found == m_primitive.attributes.end() ? -1 : found->second;
    }

    const tinygltf::Accessor& accessor(int index) const
    {
        return m_model.accessors[static_cast<std::size_t>(index)];
    }

    /// Every attribute that we read has as many elements as there are positions.
    bool checkShapes()
    {
        m_vertices = accessor(attribute("POSITION")).count;
        for (const auto& [name, index] : m_primitive.attributes) {
            if (!name.starts_with("_") && accessor(index).count != m_vertices) {
                return fail(
                    ".attributes." + name,
                    QT_TRANSLATE_NOOP("Messages", "%1 has %2 elements, but POSITION has %3"),
                    accessor(index).count, m_vertices);
            }
        }
        return true;
    }

    bool needsType(int index, int type, const std::string& name)
    {
        return accessor(index).type == type || fail(".attributes." + name, kWrongType);
    }

    bool readPositions()
    {
        const int index = attribute("POSITION");
        if (!needsType(index, TINYGLTF_TYPE_VEC3, "POSITION")) {
            return false;
        }
        m_data.positions = readVectors(index, "POSITION");
        return addMorph("POSITION", m_data.positions);
    }

    void repair(std::vector<float>& values, const std::string& name)
    {
        if (const std::size_t bad = replaceNonFinite(values); bad > 0) {
            m_data.warnings.emplace_back(
                QT_TRANSLATE_NOOP("Messages",
                                  "%1 has %2 values that are no numbers; they are read as 0."),
                m_request.place + ".attributes." + name, bad);
        }
    }

    std::vector<glm::vec3> readVectors(int index, const std::string& name)
    {
        FloatArray array = readFloats(m_model, index);
        repair(array.values, name);
        std::vector<glm::vec3> vectors(array.count);
        for (std::size_t i = 0; i < array.count; ++i) {
            const float* v = array.at(i);
            vectors[i] = {v[0], v[1], v[2]};
        }
        return vectors;
    }

    /// Morph targets at rest: the base shape plus the resting weights times the targets.
    bool addMorph(const char* name, std::vector<glm::vec3>& values)
    {
        const std::size_t count =
            std::min(m_request.morphWeights.size(), m_primitive.targets.size());
        for (std::size_t t = 0; t < count; ++t) {
            const auto weight = static_cast<float>(m_request.morphWeights[t]);
            const auto found = m_primitive.targets[t].find(name);
            if (found == m_primitive.targets[t].end() || weight == 0.0F || !std::isfinite(weight)) {
                continue;
            }
            const tinygltf::Accessor& target = accessor(found->second);
            if (target.count != m_vertices || target.type != TINYGLTF_TYPE_VEC3) {
                return fail(".targets[" + std::to_string(t) + "]." + name,
                            QT_TRANSLATE_NOOP("Messages", "%1 does not fit POSITION"));
            }
            const std::vector<glm::vec3> delta = readVectors(found->second, name);
            for (std::size_t i = 0; i < values.size(); ++i) {
                values[i] += delta[i] * weight;
            }
        }
        return true;
    }

    bool readShading()
    {
        if (const int index = attribute("NORMAL"); index >= 0) {
            if (!needsType(index, TINYGLTF_TYPE_VEC3, "NORMAL")) {
                return false;
            }
            m_data.normals = readVectors(index, "NORMAL");
            if (!addMorph("NORMAL", m_data.normals)) {
                return false;
            }
            normalize();
        }
        return readUv() && readColors();
    }

    void normalize()
    {
        for (glm::vec3& normal : m_data.normals) {
            const float length = glm::length(normal);
            normal = length > 0.0F ? normal / length : glm::vec3(0.0F, 1.0F, 0.0F);
        }
    }

    bool readUv()
    {
        m_data.uv.assign(m_vertices, glm::vec2(0.0F));
        const std::string name = "TEXCOORD_" + std::to_string(m_request.texCoord);
        const int index = attribute(name);
        if (index < 0) {
            return true;
        }
        if (!needsType(index, TINYGLTF_TYPE_VEC2, name)) {
            return false;
        }
        FloatArray array = readFloats(m_model, index);
        repair(array.values, name);
        for (std::size_t i = 0; i < m_vertices; ++i) {
            m_data.uv[i] = {array.at(i)[0], array.at(i)[1]};
        }
        return true;
    }

    bool readColors()
    {
        m_data.colors.assign(m_vertices, glm::u8vec4(255));
        const int index = attribute("COLOR_0");
        if (index < 0) {
            return true;
        }
        FloatArray array = readFloats(m_model, index);
        if (array.components != 3 && array.components != 4) {
            return fail(".attributes.COLOR_0", kWrongType);
        }
        repair(array.values, "COLOR_0");
        for (std::size_t i = 0; i < m_vertices; ++i) {
            for (std::size_t c = 0; c < array.components; ++c) {
                const float value = std::clamp(array.at(i)[c], 0.0F, 1.0F);
                m_data.colors[i][static_cast<int>(c)] =
                    static_cast<std::uint8_t>(std::lround(value * 255.0F));
            }
        }
        return true;
    }

    bool readInfluences()
    {
        if (m_request.joints == 0) {
            return true;
        }
        int sets = 0;
        while (sets < kMaxInfluenceSets && attribute("JOINTS_" + std::to_string(sets)) >= 0 &&
               attribute("WEIGHTS_" + std::to_string(sets)) >= 0) {
            ++sets;
        }
        m_data.influences = sets * 4;
        m_data.joints.assign(m_vertices * static_cast<std::size_t>(m_data.influences), 0);
        m_data.weights.assign(m_data.joints.size(), 0.0F);
        for (int set = 0; set < sets; ++set) {
            if (!readInfluenceSet(set)) {
                return false;
            }
        }
        return sets == 0 || settleInfluences();
    }

    bool readInfluenceSet(int set)
    {
        const std::string number = std::to_string(set);
        const int jointsIndex = attribute("JOINTS_" + number);
        const int weightsIndex = attribute("WEIGHTS_" + number);
        if (!needsType(jointsIndex, TINYGLTF_TYPE_VEC4, "JOINTS_" + number) ||
            !needsType(weightsIndex, TINYGLTF_TYPE_VEC4, "WEIGHTS_" + number)) {
            return false;
        }
        const std::vector<std::uint32_t> joints = readWholes(m_model, jointsIndex);
        FloatArray weights = readFloats(m_model, weightsIndex);
        repair(weights.values, "WEIGHTS_" + number);
        const auto stride = static_cast<std::size_t>(m_data.influences);
        for (std::size_t i = 0; i < m_vertices; ++i) {
            const std::size_t to = i * stride + static_cast<std::size_t>(set) * 4;
            for (std::size_t c = 0; c < 4; ++c) {
                m_data.joints[to + c] = joints[i * 4 + c];
                m_data.weights[to + c] = std::max(weights.at(i)[c], 0.0F);
            }
        }
        return true;
    }

    /// Joints exist, weights sum to one; joints without weight become joint 0.
    bool settleInfluences()
    {
        const auto stride = static_cast<std::size_t>(m_data.influences);
        for (std::size_t i = 0; i < m_vertices; ++i) {
            float* weights = m_data.weights.data() + i * stride;
            std::uint32_t* joints = m_data.joints.data() + i * stride;
            double sum = 0.0;
            for (std::size_t c = 0; c < stride; ++c) {
                sum += static_cast<double>(weights[c]);
                if (weights[c] > 0.0F && joints[c] >= m_request.joints) {
                    return fail(
                        "",
                        QT_TRANSLATE_NOOP(
                            "Messages", "%1: vertex %2 follows joint %3, but the skin has only %4"),
                        i, joints[c], m_request.joints);
                }
                joints[c] = joints[c] < m_request.joints ? joints[c] : 0U;
            }
            if (sum <= 0.0) {
                weights[0] = 1.0F;
                continue;
            }
            for (std::size_t c = 0; c < stride; ++c) {
                weights[c] = static_cast<float>(static_cast<double>(weights[c]) / sum);
            }
        }
        return true;
    }

    bool readIndices()
    {
        std::vector<std::uint32_t> raw;
        if (m_primitive.indices < 0) {
            raw.resize(m_vertices);
            for (std::size_t i = 0; i < raw.size(); ++i) {
                raw[i] = static_cast<std::uint32_t>(i);
            }
        } else {
            const tinygltf::Accessor& from = accessor(m_primitive.indices);
            if (from.type != TINYGLTF_TYPE_SCALAR || !isUnsigned(from.componentType)) {
                return fail(".indices", kWrongType);
            }
            raw = readScalars(m_model, m_primitive.indices);
            const auto bad = std::find_if(raw.begin(), raw.end(),
                                          [this](std::uint32_t i) { return i >= m_vertices; });
            if (bad != raw.end()) {
                return fail(
                    ".indices",
                    QT_TRANSLATE_NOOP(
                        "Messages", "%1: index %2 at position %3, but there are only %4 vertices"),
                    *bad, bad - raw.begin(), m_vertices);
            }
        }
        return expand(std::move(raw));
    }

    /// glTF 2.0, section 3.7.2.1.
    bool expand(std::vector<std::uint32_t> raw)
    {
        const std::size_t count = raw.size();
        std::vector<std::uint32_t>& out = m_data.indices;
        if (m_primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
            for (std::size_t i = 0; i + 2 < count; ++i) {
                out.insert(out.end(), {raw[i], raw[i + 1 + i % 2], raw[i + 2 - i % 2]});
            }
        } else if (m_primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
            for (std::size_t i = 0; i + 2 < count; ++i) {
                out.insert(out.end(), {raw[i + 1], raw[i + 2], raw[0]});
            }
        } else {
            if (count % 3 != 0) {
                m_data.warnings.emplace_back(
                    QT_TRANSLATE_NOOP(
                        "Messages",
                        "%1 ends with %2 corners that make no triangle; they are left out."),
                    m_request.place, count % 3);
                raw.resize(count - count % 3);
            }
            out = std::move(raw);
        }
        return true;
    }

    const tinygltf::Model& m_model;
    const tinygltf::Primitive& m_primitive;
    const PrimitiveRequest& m_request;
    std::size_t m_vertices = 0;
    PrimitiveData m_data;
    Message m_problem;
};

} // namespace

bool drawsTriangles(const tinygltf::Primitive& primitive)
{
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    return mode >= TINYGLTF_MODE_TRIANGLES && primitive.attributes.contains("POSITION");
}

Result<PrimitiveData> decodePrimitive(const tinygltf::Model& model,
                                      const tinygltf::Primitive& primitive,
                                      const PrimitiveRequest& request)
{
    return Decoder(model, primitive, request).run();
}

} // namespace crowd::model::gltf

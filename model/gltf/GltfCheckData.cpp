// SPDX-License-Identifier: MIT
#include "model/gltf/GltfCheckData.h"

#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfValidate.h"

namespace crowd::model::gltf {

namespace {

class DataCheck
{
public:
    explicit DataCheck(JsonCheck& check) : m_check(check) {}

    bool run()
    {
        return m_check.each(m_check.root(), "buffers", "",
                            [this](Json& buffer, const std::string& where) {
                                return m_check.whole(buffer, "byteLength", where, 0,
                                                     kMaxBufferBytes, JsonCheck::Need::Required);
                            }) &&
               m_check.each(m_check.root(), "bufferViews", "",
                            [this](Json& view, const std::string& where) {
                                return m_check.index(view, "buffer", "buffers", where,
                                                     JsonCheck::Need::Required) &&
                                       m_check.whole(view, "byteOffset", where, 0,
                                                     kMaxBufferBytes) &&
                                       m_check.whole(view, "byteLength", where, 0, kMaxBufferBytes,
                                                     JsonCheck::Need::Required) &&
                                       checkStride(view, where);
                            }) &&
               m_check.each(m_check.root(), "accessors", "",
                            [this](Json& accessor, const std::string& where) {
                                return checkAccessor(accessor, where);
                            });
    }

private:
    bool checkStride(Json& view, const std::string& where)
    {
        return m_check.whole(view, "byteStride", where, 0, 252) &&
               (wholeOr(view, "byteStride", 0) % 4 == 0 ||
                m_check.fail(where + ".byteStride",
                             QT_TRANSLATE_NOOP("Messages", "%1 is no multiple of 4")));
    }

    bool checkAccessor(Json& accessor, const std::string& where)
    {
        if (!m_check.index(accessor, "bufferView", "bufferViews", where) ||
            !m_check.whole(accessor, "byteOffset", where, 0, kMaxBufferBytes) ||
            !m_check.whole(accessor, "count", where, 0, kMaxAccessorElements,
                           JsonCheck::Need::Required) ||
            !m_check.whole(accessor, "componentType", where, 5120, 5126,
                           JsonCheck::Need::Required)) {
            return false;
        }
        if (componentBytes(wholeOr(accessor, "componentType", 0)) == 0) {
            return m_check.fail(where + ".componentType",
                                QT_TRANSLATE_NOOP("Messages", "%1 is none that glTF 2.0 knows"));
        }
        if (componentCount(textOf(accessor, "type")) == 0) {
            return m_check.fail(where + ".type",
                                QT_TRANSLATE_NOOP("Messages", "%1 is none that glTF 2.0 knows"));
        }
        if (wholeOr(accessor, "count", 0) * componentCount(textOf(accessor, "type")) >
            kMaxAccessorNumbers) {
            return m_check.fail(where, QT_TRANSLATE_NOOP("Messages", "%1 has more than %2 numbers"),
                                kMaxAccessorNumbers);
        }
        const auto sparse = accessor.find("sparse");
        return sparse == accessor.end() || checkSparse(accessor, *sparse, where + ".sparse");
    }

    bool checkSparse(const Json& accessor, Json& sparse, const std::string& where)
    {
        if (!sparse.is_object() || !member(sparse, "indices").is_object() ||
            !member(sparse, "values").is_object()) {
            return m_check.fail(where,
                                QT_TRANSLATE_NOOP("Messages", "%1 lacks its indices or values"));
        }
        Json& indexPart = sparse["indices"];
        Json& valuePart = sparse["values"];
        if (!m_check.whole(sparse, "count", where, 0, wholeOr(accessor, "count", 0),
                           JsonCheck::Need::Required) ||
            !m_check.index(indexPart, "bufferView", "bufferViews", where + ".indices",
                           JsonCheck::Need::Required) ||
            !m_check.whole(indexPart, "byteOffset", where + ".indices", 0, kMaxBufferBytes) ||
            !m_check.whole(indexPart, "componentType", where + ".indices", 5121, 5125,
                           JsonCheck::Need::Required) ||
            !m_check.index(valuePart, "bufferView", "bufferViews", where + ".values",
                           JsonCheck::Need::Required) ||
            !m_check.whole(valuePart, "byteOffset", where + ".values", 0, kMaxBufferBytes)) {
            return false;
        }
        const std::uint64_t type = wholeOr(indexPart, "componentType", 0);
        return type == 5121 || type == 5123 || type == 5125 ||
               m_check.fail(where + ".indices.componentType",
                            QT_TRANSLATE_NOOP("Messages", "%1 is not an unsigned type"));
    }

    JsonCheck& m_check;
};

} // namespace

bool checkData(JsonCheck& check)
{
    return DataCheck(check).run();
}

} // namespace crowd::model::gltf

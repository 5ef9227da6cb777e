// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QtCore/QTemporaryDir>

#include "model/gltf/GltfImport.h"
#include "tests/model/GltfBuilder.h"

namespace gltf_samples {

/// A folder for a test's glTF files, gone with it.
class GltfFolder
{
public:
    /// The path of "test.glb", which holds what the builder does from now on.
    [[nodiscard]] std::string save(const GltfBuilder& builder) const
    {
        return writeFile(filePath(QStringLiteral("test.glb")), builder.glb());
    }

    /// That file, imported; ends the test where it cannot be.
    [[nodiscard]] crowd::model::TemplatePtr
    load(const GltfBuilder& builder, const crowd::model::ImportSettings& settings = {}) const
    {
        const auto asset = crowd::model::importTemplate(save(builder), settings);
        if (!asset) {
            qFatal("%s", asset.error().message.c_str());
        }
        return asset.value();
    }

    [[nodiscard]] QString filePath(const QString& name) const { return m_folder.filePath(name); }
    [[nodiscard]] QString path() const { return m_folder.path(); }

private:
    QTemporaryDir m_folder;
};

} // namespace gltf_samples

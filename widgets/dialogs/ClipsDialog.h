// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QtWidgets/QDialog>

#include "model/bake/KeyframeStore.h"
#include "model/scene/Scene.h"

namespace crowd::widgets {

class ClipTable;

/// What the clips of a template in the scene are for and how fast they go, with a preview: what the
/// import dialog asks of them, asked again. Owns nothing of the document. Main thread.
class ClipsDialog : public QDialog
{
    Q_OBJECT

public:
    /// `asset`: of the entry, as its file has it, without the artist's speeds.
    ClipsDialog(const model::TemplateEntry& entry, const model::TemplatePtr& asset,
                model::KeyframeStore& keyframes, QWidget* parent);

    /// As TemplateEntry has them.
    [[nodiscard]] std::vector<float> clipSpeeds() const;
    [[nodiscard]] std::vector<std::optional<model::ClipRole>> clipRoles() const;

private:
    ClipTable* m_clips;
};

} // namespace crowd::widgets

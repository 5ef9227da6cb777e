// SPDX-License-Identifier: MIT
#include "widgets/dialogs/ClipsDialog.h"

#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QVBoxLayout>

#include "widgets/dialogs/ClipTable.h"
#include "widgets/dialogs/TemplatePreview.h"

namespace crowd::widgets {

ClipsDialog::ClipsDialog(const model::TemplateEntry& entry, const model::TemplatePtr& asset,
                         model::KeyframeStore& keyframes, QWidget* parent)
    : QDialog(parent), m_clips(new ClipTable(*asset, this))
{
    setWindowTitle(tr("Clips of “%1”").arg(QString::fromStdString(entry.name)));
    m_clips->setEdited(entry.clipSpeeds, entry.clipRoles);
    auto* preview = new TemplatePreview(keyframes, this);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_clips, &QTableWidget::currentCellChanged, this,
            [this, preview, asset] { preview->show(asset, m_clips->shownClip()); });
    auto* columns = new QHBoxLayout;
    columns->addWidget(preview, 1);
    columns->addWidget(m_clips, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(columns, 1);
    layout->addWidget(buttons);
    resize(960, 520);
    preview->show(asset, m_clips->shownClip());
}

std::vector<float> ClipsDialog::clipSpeeds() const
{
    return m_clips->editedSpeeds();
}

std::vector<std::optional<model::ClipRole>> ClipsDialog::clipRoles() const
{
    return m_clips->editedRoles();
}

} // namespace crowd::widgets

// SPDX-License-Identifier: MIT
#include "widgets/dialogs/MissingAssetsDialog.h"

#include "model/base/Translated.h"

#include <algorithm>

#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeWidget>
#include <QtWidgets/QVBoxLayout>

#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

MissingAssetsDialog::MissingAssetsDialog(EditorState& state, QWidget* parent)
    : QDialog(parent), m_state(state), m_text(new QLabel(this)), m_list(new QTreeWidget(this))
{
    setObjectName(QStringLiteral("missingAssets"));
    setWindowTitle(tr("Missing Assets"));
    m_text->setWordWrap(true);
    m_list->setHeaderLabels({tr("Name"), tr("Kind"), tr("Was at")});
    m_list->setRootIsDecorated(false);
    m_list->setTextElideMode(Qt::ElideMiddle);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_locate = buttons->addButton(tr("&Locate…"), QDialogButtonBox::ActionRole);
    m_locate->setObjectName(QStringLiteral("locate"));
    m_locate->setDefault(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_text);
    layout->addWidget(m_list);
    layout->addWidget(buttons);
    resize(640, 320);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_locate, &QPushButton::clicked, this, &MissingAssetsDialog::locateCurrent);
    connect(m_list, &QTreeWidget::itemActivated, this, &MissingAssetsDialog::locateCurrent);
    connect(&state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                visitChange(
                    change, [this](const model::TemplatesChanged&) { refresh(); },
                    [this](const model::StagesChanged&) { refresh(); },
                    // The list belongs to the scene that has gone.
                    [this](const model::SceneReplaced&) { reject(); });
            });
    refresh();
}

void MissingAssetsDialog::refresh()
{
    const int current = std::max(m_list->indexOfTopLevelItem(m_list->currentItem()), 0);
    m_missing = model::missingAssets(m_state.scene());
    m_list->clear();
    for (const model::MissingAsset& asset : m_missing) {
        auto* item = new QTreeWidgetItem(m_list, {QString::fromStdString(asset.name),
                                                  asset.isStage ? tr("Stage") : tr("Template"),
                                                  QString::fromStdString(asset.path)});
        item->setToolTip(0, model::translated(asset.problem));
        item->setToolTip(2, model::translated(asset.problem));
    }
    if (m_missing.empty()) {
        accept();
        return;
    }
    m_list->header()->resizeSections(QHeaderView::ResizeToContents);
    m_list->setCurrentItem(
        m_list->topLevelItem(std::min(current, m_list->topLevelItemCount() - 1)));
    m_text->setText(tr(
        "%n asset(s) of this scene could not be loaded. The scene is intact and can be saved "
        "without loss; what they draw is not shown. When one is found, the others are looked for "
        "near it.",
        nullptr, static_cast<int>(m_missing.size())));
}

void MissingAssetsDialog::locateCurrent()
{
    const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
    if (row >= 0) {
        const model::MissingAsset asset = m_missing[static_cast<std::size_t>(row)];
        Q_EMIT locateRequested(asset);
    }
}

} // namespace crowd::widgets

// SPDX-License-Identifier: MIT
#include "widgets/dialogs/LibraryDialog.h"

#include <algorithm>

#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "widgets/dialogs/TemplatePictures.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kSwatchPixels = 96; ///< logical
constexpr QSize kCell{116, 126};
constexpr QSize kFirstSize{640, 460};

QString readable(const std::string& name)
{
    return QString::fromStdString(name).replace(QLatin1Char('_'), QLatin1Char(' '));
}

} // namespace

LibraryDialog::LibraryDialog(std::vector<model::TemplateEntry> library,
                             const std::vector<model::TemplateEntry>& present,
                             model::KeyframeStore& keyframes, QWidget* parent)
    : QDialog(parent), m_library(std::move(library)), m_keyframes(keyframes),
      m_list(new QListWidget(this))
{
    setObjectName(QStringLiteral("libraryDialog"));
    setWindowTitle(tr("Add from Library"));
    m_list->setViewMode(QListView::IconMode);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setMovement(QListView::Static);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setIconSize({kSwatchPixels, kSwatchPixels});
    m_list->setGridSize(kCell);
    auto* hint = new QLabel(
        tr("Choose whom to paint with; Ctrl or Shift and a click choose several."), this);
    hint->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_add = buttons->button(QDialogButtonBox::Ok);
    m_add->setText(tr("&Add"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_list, &QListWidget::itemSelectionChanged, this, &LibraryDialog::refresh);
    connect(m_list, &QListWidget::itemDoubleClicked, this, [this] {
        if (m_add->isEnabled()) {
            accept();
        }
    });
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(hint);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttons);
    resize(kFirstSize);
    fill(present);
    refresh();
    connect(&m_drawing, &QTimer::timeout, this, &LibraryDialog::drawNextPicture);
    m_drawing.start(0);
}

void LibraryDialog::fill(const std::vector<model::TemplateEntry>& present)
{
    for (const model::TemplateEntry& entry : m_library) {
        auto* item = new QListWidgetItem(iconNamed("person"), readable(entry.name), m_list);
        const bool isThere =
            std::ranges::find(present, entry.path, &model::TemplateEntry::path) != present.end();
        if (isThere || !entry.asset) {
            item->setFlags(Qt::NoItemFlags);
            item->setToolTip(isThere ? tr("Is in the scene already")
                                     : model::translated(entry.problem));
        }
    }
}

void LibraryDialog::drawNextPicture()
{
    if (m_drawn >= m_list->count()) {
        m_drawing.stop();
        return;
    }
    const model::TemplateEntry& entry = m_library[static_cast<std::size_t>(m_drawn)];
    QListWidgetItem* item = m_list->item(m_drawn);
    ++m_drawn;
    if (!entry.asset) {
        item->setIcon(iconNamed("locate"));
        return;
    }
    render::ThumbnailRequest request;
    request.asset = entry.asset;
    request.size = static_cast<int>(kSwatchPixels * devicePixelRatioF());
    const QColor base = palette().color(QPalette::Base);
    request.background = {base.redF(), base.greenF(), base.blueF(), 1.0F};
    QPixmap picture = QPixmap::fromImage(templatePicture(m_keyframes, request));
    picture.setDevicePixelRatio(devicePixelRatioF());
    item->setIcon(QIcon(picture));
}

void LibraryDialog::refresh()
{
    m_add->setEnabled(!m_list->selectedItems().isEmpty());
}

std::vector<model::TemplateEntry> LibraryDialog::chosen() const
{
    std::vector<model::TemplateEntry> entries;
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->isSelected()) {
            entries.push_back(m_library[static_cast<std::size_t>(row)]);
        }
    }
    return entries;
}

} // namespace crowd::widgets

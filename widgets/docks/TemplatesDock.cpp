// SPDX-License-Identifier: MIT
#include "widgets/docks/TemplatesDock.h"

#include <algorithm>

#include <QtCore/QEvent>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "model/document/SceneEdit.h"
#include "widgets/dialogs/TemplatePictures.h"
#include "widgets/docks/TemplateDelegate.h"
#include "widgets/forms/ValueSlider.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

std::vector<model::TemplateWeight>::iterator weightOf(std::vector<model::TemplateWeight>& mix,
                                                      model::TemplateId id)
{
    return std::ranges::find(mix, id, &model::TemplateWeight::id);
}

} // namespace

TemplatesDock::TemplatesDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Templates"), "templates", parent), m_state(state), m_list(new QListWidget(this)),
      m_weight(
          new ValueSlider(tr("Weight"), {1.0, 100.0, 5.0, 0, QStringLiteral(" %"), false}, this)),
      m_library(new QToolButton(this)), m_import(new QToolButton(this))
{
    m_list->setItemDelegate(new TemplateDelegate(m_list));
    m_list->setViewMode(QListView::IconMode);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setMovement(QListView::Static);
    m_list->setUniformItemSizes(true);
    m_list->setSpacing(2);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->setToolTip(tr("Ticked templates are painted by the create brush; a double click "
                          "paints one alone"));
    m_weight->setToolTip(tr("How often the chosen template comes in the mix"));
    m_library->setToolTip(tr("Add from the library of built-in characters"));
    m_library->setAutoRaise(true);
    m_library->setIcon(iconNamed("add"));
    m_library->setObjectName(QStringLiteral("library"));
    m_import->setToolTip(tr("Import templates from files"));
    m_import->setAutoRaise(true);
    m_import->setIcon(iconNamed("import"));

    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_list, 1);
    auto* row = new QHBoxLayout;
    row->addWidget(m_weight, 1);
    row->addWidget(m_library);
    row->addWidget(m_import);
    layout->addLayout(row);
    setWidget(content);
    connectParts();
    rebuild();
}

void TemplatesDock::connectParts()
{
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(0);
    connect(&m_rebuild, &QTimer::timeout, this, &TemplatesDock::rebuild);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::TemplatesChanged, model::SceneReplaced>(change)) {
                    m_rebuild.start();
                }
            });
    connect(&m_state, &EditorState::brushChanged, this, &TemplatesDock::refreshMix);
    connect(m_library, &QToolButton::clicked, this, &TemplatesDock::libraryRequested);
    connect(m_import, &QToolButton::clicked, this, &TemplatesDock::importRequested);
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (!m_isFilling) {
            rename(item);
            setInMix(static_cast<model::TemplateId>(item->data(kIdRole).toUInt()),
                     item->checkState() == Qt::Checked);
        }
    });
    connect(m_list, &QListWidget::currentItemChanged, this, &TemplatesDock::refreshMix);
    connect(m_list, &QListWidget::customContextMenuRequested, this, &TemplatesDock::showMenu);
    removeByKey(*m_list, [this] {
        if (const QListWidgetItem* item = m_list->currentItem()) {
            Q_EMIT removeRequested(static_cast<model::TemplateId>(item->data(kIdRole).toUInt()));
        }
    });
    connect(m_list, &QListWidget::itemDoubleClicked, this, [this](QListWidgetItem* item) {
        model::BrushSettings brush = m_state.brush(model::BrushKind::Create);
        brush.as<model::CreateSettings>().mix = {
            {static_cast<model::TemplateId>(item->data(kIdRole).toUInt()), 1.0F}};
        m_state.setBrush(brush);
    });
    connect(m_weight, &ValueSlider::valueEdited, this, &TemplatesDock::setWeight);
}

void TemplatesDock::changeEvent(QEvent* event)
{
    DockBase::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        m_library->setIcon(iconNamed("add"));
        m_import->setIcon(iconNamed("import"));
        m_pictures.clear(); // their ground is the list's
        m_rebuild.start();
    }
}

QIcon TemplatesDock::pictureOf(const model::TemplateEntry& entry)
{
    if (!entry.asset) {
        return iconNamed("locate");
    }
    const auto known = m_pictures.find(entry.asset);
    if (known != m_pictures.end()) {
        return known->second;
    }
    render::ThumbnailRequest request;
    request.asset = entry.asset;
    request.size = static_cast<int>(TemplateDelegate::kPictureSize * devicePixelRatioF());
    const QColor base = palette().color(QPalette::AlternateBase);
    request.background = {base.redF(), base.greenF(), base.blueF(), 1.0F};
    QPixmap picture = QPixmap::fromImage(templatePicture(m_state.keyframes(), request));
    picture.setDevicePixelRatio(devicePixelRatioF());
    return m_pictures[entry.asset] = QIcon(picture);
}

void TemplatesDock::rebuild()
{
    m_isFilling = true;
    const model::TemplateId current = currentId();
    m_list->clear();
    std::erase_if(m_pictures, [this](const auto& known) {
        return std::ranges::none_of(m_state.scene().templates,
                                    [&](const auto& entry) { return entry.asset == known.first; });
    });
    for (const model::TemplateEntry& entry : m_state.scene().templates) {
        auto* item = new QListWidgetItem(pictureOf(entry), QString::fromStdString(entry.name));
        item->setData(kIdRole, entry.id);
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
        item->setCheckState(Qt::Unchecked);
        item->setToolTip(entry.problem.empty() ? QString::fromStdString(entry.path)
                                               : model::translated(entry.problem));
        m_list->addItem(item);
        if (entry.id == current) {
            m_list->setCurrentItem(item);
        }
    }
    m_isFilling = false;
    refreshMix();
}

void TemplatesDock::refreshMix()
{
    m_isFilling = true;
    std::vector<model::TemplateWeight> mix =
        m_state.brush(model::BrushKind::Create).as<model::CreateSettings>().mix;
    if (mix.empty()) {
        for (const model::TemplateEntry& entry : m_state.scene().templates) {
            mix.push_back({entry.id, 1.0F});
        }
    }
    float total = 0.0F;
    for (const model::TemplateWeight& item : mix) {
        total += item.weight;
    }
    for (int row = 0; row < m_list->count(); ++row) {
        QListWidgetItem* item = m_list->item(row);
        const auto id = static_cast<model::TemplateId>(item->data(kIdRole).toUInt());
        const auto known = weightOf(mix, id);
        const bool isIn = known != mix.end();
        item->setCheckState(isIn ? Qt::Checked : Qt::Unchecked);
        item->setData(TemplateDelegate::kShareRole,
                      isIn ? static_cast<double>(known->weight / total) : -1.0);
    }
    const auto current = weightOf(mix, currentId());
    const bool hasWeight = current != mix.end();
    m_weight->setEnabled(hasWeight && mix.size() > 1);
    m_weight->setValue(hasWeight ? static_cast<double>(current->weight) * 100.0 : 100.0);
    m_isFilling = false;
}

void TemplatesDock::setInMix(model::TemplateId id, bool isIn)
{
    model::BrushSettings brush = m_state.brush(model::BrushKind::Create);
    auto& mix = brush.as<model::CreateSettings>().mix;
    if (mix.empty()) {
        for (const model::TemplateEntry& entry : m_state.scene().templates) {
            mix.push_back({entry.id, 1.0F});
        }
    }
    const auto known = weightOf(mix, id);
    if (isIn && known == mix.end()) {
        mix.push_back({id, 1.0F});
    } else if (!isIn && known != mix.end() && mix.size() > 1) {
        mix.erase(known);
    }
    m_state.setBrush(brush);
    refreshMix(); // the last one stays in
}

void TemplatesDock::setWeight(double percent)
{
    model::BrushSettings brush = m_state.brush(model::BrushKind::Create);
    const auto known = weightOf(brush.as<model::CreateSettings>().mix, currentId());
    if (known != brush.as<model::CreateSettings>().mix.end()) {
        known->weight = static_cast<float>(percent / 100.0);
        m_state.setBrush(brush);
    }
}

model::TemplateId TemplatesDock::currentId() const
{
    const QListWidgetItem* item = m_list->currentItem();
    return item == nullptr ? model::TemplateId{0}
                           : static_cast<model::TemplateId>(item->data(kIdRole).toUInt());
}

void TemplatesDock::rename(QListWidgetItem* item)
{
    const auto id = static_cast<model::TemplateId>(item->data(kIdRole).toUInt());
    const model::TemplateEntry* entry = m_state.scene().findTemplate(id);
    const std::string name = item->text().trimmed().toStdString();
    if (entry == nullptr || name.empty() || entry->name == name) {
        return;
    }
    model::TemplateEntry renamed = *entry;
    renamed.name = name;
    m_state.document().edit(tr("Rename template"),
                            [&](model::SceneEdit& edit) { edit.changeTemplate(renamed); });
}

void TemplatesDock::showMenu(const QPoint& position)
{
    QListWidgetItem* item = m_list->itemAt(position);
    QMenu menu(this);
    menu.addAction(iconNamed("add"), tr("Add from Library…"), this,
                   [this] { Q_EMIT libraryRequested(); });
    menu.addAction(iconNamed("import"), tr("Import Templates…"), this,
                   [this] { Q_EMIT importRequested(); });
    if (item != nullptr) {
        const auto id = static_cast<model::TemplateId>(item->data(kIdRole).toUInt());
        menu.addSeparator();
        menu.addAction(iconNamed("rename"), tr("Rename"), this,
                       [this, item] { m_list->editItem(item); });
        const model::TemplateEntry* entry = m_state.scene().findTemplate(id);
        menu.addAction(iconNamed("brush-walk"), tr("Clips…"), this,
                       [this, id] { Q_EMIT clipsRequested(id); })
            ->setEnabled(entry != nullptr && entry->asset != nullptr);
        menu.addAction(iconNamed("locate"), tr("Locate File…"), this,
                       [this, id] { Q_EMIT locateRequested(id); });
        menu.addAction(iconNamed("delete"), tr("Remove"), this,
                       [this, id] { Q_EMIT removeRequested(id); });
    }
    menu.exec(m_list->viewport()->mapToGlobal(position));
}

} // namespace crowd::widgets

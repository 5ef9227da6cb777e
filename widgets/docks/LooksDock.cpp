// SPDX-License-Identifier: MIT
#include "widgets/docks/LooksDock.h"

#include <algorithm>
#include <utility>

#include <QtCore/QCoreApplication>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "model/project/LookFile.h"
#include "widgets/commands/LookCommands.h"
#include "widgets/docks/LookPictures.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/LastFolder.h"
#include "widgets/forms/PanelButton.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/state/ShownLook.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

using model::LookId;
using model::LookPreset;

namespace {

constexpr int kLookIdRole = Qt::UserRole;
constexpr int kLookRows = 6;
const QString kLookFolder = QStringLiteral("looks/folder");

QString readyName(const LookPreset& ready)
{
    return QCoreApplication::translate("Looks", ready.name.c_str());
}

} // namespace

LooksDock::LooksDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Looks"), "looks", parent), m_state(state), m_edit(state.document(), this),
      m_list(new QListWidget(this)), m_note(new QLabel(this)),
      m_pictures(new LookPictures(state, *this))
{
    m_list->setObjectName(QStringLiteral("looksList"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setIconSize(LookPictures::kSize);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // long names are cut off
    m_note->setObjectName(QStringLiteral("looksNote"));
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(makeButtons());
    layout->addWidget(m_note);
    layout->addWidget(m_list);
    makeForm();
    layout->addWidget(m_form);
    layout->addStretch(1);
    setScrolledContent(content);
    connectParts();
    fill();
}

LooksDock::~LooksDock() = default;

QWidget* LooksDock::makeButtons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [row, layout](const char* icon, const QString& tip, const char* name) {
        QToolButton* button = panelButton(row, icon, tip, name);
        layout->addWidget(button);
        return button;
    };
    m_add = add("add", tr("Add a look"), "addLook");
    m_add->setPopupMode(QToolButton::InstantPopup);
    m_add->setMenu(new QMenu(m_add));
    fillAddMenu();
    layout->addStretch(1);
    QToolButton* remove = add("delete", tr("Remove the chosen look"), "removeLook");
    connect(remove, &QToolButton::clicked, this, [this] { removeLook(m_state, shown().id); });
    m_remove = remove;
    removeByKey(*m_list, [remove] { remove->click(); });
    return row;
}

void LooksDock::fillAddMenu()
{
    QMenu& menu = *m_add->menu();
    menu.addAction(tr("The View as It Is"), this,
                   [this] { (void)addLook(m_state, lookOfView(m_state), tr("Look")); });
    menu.addSeparator();
    for (const LookPreset& ready : readyLooks()) {
        menu.addAction(readyName(ready), this,
                       [this, &ready] { (void)addLook(m_state, ready, readyName(ready)); });
    }
    menu.addSeparator();
    menu.addAction(tr("From a File…"), this, &LooksDock::takeFile);
}

void LooksDock::makeForm()
{
    const FormTarget target{[this]() -> const void* { return &shown(); },
                            [this](const auto& apply) { change(apply); },
                            [this] {
                                return model::FieldContext{&m_state.scene(), nullptr};
                            }};
    m_form = new FieldForm(target, QStringLiteral("look"), &m_state, this);
    m_form->setObjectName(QStringLiteral("lookForm"));
    m_form->addFields(model::fieldsOf<LookPreset>());
    m_form->finish();
    connect(m_form, &FieldForm::held, &m_edit, &HeldEdit::hold);
}

void LooksDock::connectParts()
{
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::SceneReplaced, model::LightingChanged, model::LightsChanged>(
                        change)) {
                    m_pictures->forget();
                }
                if (isOneOf<model::LooksChanged, model::SceneReplaced, model::LightingChanged,
                            model::LightsChanged>(change)) {
                    fill();
                }
            });
    connect(&m_state, &EditorState::viewOptionsChanged, this, &LooksDock::markShown);
    connect(m_pictures, &LookPictures::drawn, this, &LooksDock::fill);
    connect(this, &QDockWidget::visibilityChanged, this, [this](bool isSeen) {
        if (isSeen) {
            fill(); // with pictures of now
        }
    });
    connect(m_list, &QListWidget::itemSelectionChanged, this, &LooksDock::choose);
    connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (!m_isFilling) {
            takeName(*item);
        }
    });
    connect(m_list, &QListWidget::customContextMenuRequested, this, &LooksDock::showMenu);
}

void LooksDock::fill()
{
    if (m_list->viewport()->findChild<QLineEdit*>() != nullptr) {
        return; // not under the hands of who renames
    }
    m_isFilling = true;
    m_list->clear();
    auto* none = new QListWidgetItem(iconNamed("look"), tr("None"), m_list);
    none->setToolTip(tr("Click: draw the view as the scene is lit"));
    for (const LookPreset& look : m_state.scene().looks) {
        auto* item =
            new QListWidgetItem(m_pictures->of(look), QString::fromStdString(look.name), m_list);
        item->setData(kLookIdRole, look.id);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setToolTip(tr("Click: draw the view so. Double click or F2: rename."));
    }
    m_isFilling = false;
    const bool isEmpty = m_state.scene().looks.empty();
    m_note->setText(
        tr("A look is a style with a light, a background and outlines of its own, under "
           "a name: studio, evening, comic. + adds one."));
    m_note->setVisible(isEmpty);
    m_list->setVisible(!isEmpty);
    int height = 2 * m_list->frameWidth() + 4;
    for (int row = 0; row < std::min(m_list->count(), kLookRows); ++row) {
        height += m_list->sizeHintForRow(row);
    }
    m_list->setFixedHeight(height);
    markShown();
}

void LooksDock::markShown()
{
    const LookPreset* look = shownLook(m_state);
    const model::Looks& looks = m_state.scene().looks;
    const auto place = std::ranges::find(looks, look != nullptr ? look->id : 0, &LookPreset::id);
    m_isFilling = true;
    m_list->setCurrentRow(look != nullptr ? static_cast<int>(place - looks.begin()) + 1 : 0);
    m_isFilling = false;
    m_remove->setEnabled(look != nullptr);
    m_form->setVisible(look != nullptr);
    m_form->refresh();
}

void LooksDock::choose()
{
    const QListWidgetItem* item = m_list->currentItem();
    if (!m_isFilling && item != nullptr) {
        showLook(m_state, item->data(kLookIdRole).toUInt());
    }
}

void LooksDock::takeName(const QListWidgetItem& item)
{
    (void)renameLook(m_state, item.data(kLookIdRole).toUInt(), item.text());
    // After the list has closed its line: what was refused gets its old name back.
    QMetaObject::invokeMethod(this, &LooksDock::fill, Qt::QueuedConnection);
}

void LooksDock::showMenu(const QPoint& position)
{
    const QListWidgetItem* item = m_list->itemAt(position);
    const LookId id = item != nullptr ? item->data(kLookIdRole).toUInt() : 0;
    if (id == 0) {
        return;
    }
    const int row = m_list->row(item);
    QMenu menu(this);
    menu.addAction(tr("Rename"), this, [this, row] { m_list->editItem(m_list->item(row)); });
    menu.addAction(tr("Duplicate"), this, [this, id] {
        if (const LookPreset* look = model::findLook(m_state.scene().looks, id)) {
            (void)addLook(m_state, *look, QString::fromStdString(look->name));
        }
    });
    menu.addAction(tr("Up"), this, [this, id] { moveLook(m_state, id, -1); })->setEnabled(row > 1);
    menu.addAction(tr("Down"), this, [this, id] { moveLook(m_state, id, 1); })
        ->setEnabled(row + 1 < m_list->count());
    menu.addSeparator();
    menu.addAction(tr("Save as a File…"), this, &LooksDock::saveShown);
    menu.addAction(tr("Remove"), this, [this, id] { removeLook(m_state, id); });
    menu.exec(m_list->viewport()->mapToGlobal(position));
}

void LooksDock::takeFile()
{
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Take Looks"), inLastFolder(kLookFolder, m_state.document().path(), {}),
        tr("Looks (*%1)").arg(QLatin1Char('.') + QLatin1String(model::kLookFileEnding)));
    if (path.isEmpty()) {
        return;
    }
    rememberFolder(kLookFolder, path);
    const auto taken = importLooks(m_state, path);
    m_state.showStatus(taken ? tr("Looks taken from %1").arg(path)
                             : model::translated(taken.error().said));
}

void LooksDock::saveShown()
{
    const LookId id = shown().id;
    const QString ending = QLatin1Char('.') + QLatin1String(model::kLookFileEnding);
    QString path =
        QFileDialog::getSaveFileName(this, tr("Save the Look"),
                                     inLastFolder(kLookFolder, m_state.document().path(),
                                                  QString::fromStdString(shown().name) + ending),
                                     tr("Looks (*%1)").arg(ending));
    if (path.isEmpty()) {
        return;
    }
    rememberFolder(kLookFolder, path);
    path += path.endsWith(ending) ? QString() : ending;
    const auto saved = exportLook(m_state, id, path);
    m_state.showStatus(
        saved ? tr("Saved as %1").arg(path)
              : tr("%1 cannot be saved: %2").arg(path, model::translated(saved.error().said)));
}

const LookPreset& LooksDock::shown() const
{
    static const LookPreset kNone;
    const LookPreset* look = shownLook(m_state);
    return look != nullptr ? *look : kNone;
}

void LooksDock::change(const std::function<void(void*)>& apply)
{
    const model::Lighting seen = lightIn(shown(), m_state.scene().lighting);
    model::Looks looks =
        withLook(m_state.scene().looks, shown().id, [&apply, &seen](LookPreset& look) {
            apply(&look);
            if (look.light == model::LookLight::Own && look.ownLight == model::Lighting()) {
                look.ownLight = seen; // what is to be changed from here on
            }
        });
    if (!m_edit.put(tr("Change a look"),
                    [&looks](model::SceneEdit& edit) { edit.setLooks(std::move(looks)); })) {
        m_form->refresh();
    }
}

} // namespace crowd::widgets

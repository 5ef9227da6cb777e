// SPDX-License-Identifier: MIT
#include "widgets/docks/BrushSettingsDock.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QAction>

#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

BrushSettingsDock::BrushSettingsDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Brush Settings"), "brushSettings", parent), m_state(state)
{
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(0);
    connect(&m_rebuild, &QTimer::timeout, this, &BrushSettingsDock::rebuild);
    connect(&m_state, &EditorState::toolChanged, this, [this] { m_rebuild.start(); });
    connect(&m_state, &EditorState::hintChanged, this, &BrushSettingsDock::sayWhatItDoes);
    connect(&m_state, &EditorState::scriptBrushesChanged, this, [this] {
        if (m_state.tool() == ToolId::BrushScript) {
            m_rebuild.start();
        }
    });
    connect(&m_state, &EditorState::brushChanged, this, [this] {
        if (m_form != nullptr) {
            m_form->refresh();
        }
    });
    // Slots, clips, seats, groups and states on offer are those of the scene.
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                const bool isWalk = brushKindOf(m_state.tool()) == model::BrushKind::Walk;
                if (isOneOf<model::TemplatesChanged, model::StagesChanged, model::RulesChanged,
                            model::GroupsChanged, model::StatesChanged, model::FeaturesChanged,
                            model::RelationKindsChanged, model::SceneReplaced>(change) ||
                    (isWalk && isOneOf<model::PathsChanged>(change))) {
                    m_rebuild.start();
                }
            });
    rebuild();
}

void BrushSettingsDock::rebuild()
{
    delete widget();
    m_form = nullptr;
    m_note = nullptr;
    const ToolInfo& tool = toolInfo(m_state.tool());
    const std::string& script =
        m_state.brush(model::BrushKind::Script).as<model::ScriptSettings>().brush;
    setWindowTitle(tool.id == ToolId::BrushScript && !script.empty()
                       ? tr("Script Brush: %1").arg(QString::fromStdString(script))
                       : QCoreApplication::translate("Tools", tool.name));
    toggleViewAction()->setText(tr("Brush Settings")); // the menu names the panel, not the brush
    if (!tool.brush) {
        m_note = new QLabel(this);
        m_note->setObjectName(QStringLiteral("toolNote"));
        m_note->setWordWrap(true);
        m_note->setMargin(8);
        m_note->setAlignment(Qt::AlignTop);
        setScrolledContent(m_note);
        sayWhatItDoes();
        return;
    }
    m_form = makeBrushForm(m_state, *tool.brush, this);
    setScrolledContent(m_form);
}

/// Of a tool that has nothing to set: what the status bar may have no room for.
void BrushSettingsDock::sayWhatItDoes()
{
    if (m_note != nullptr) {
        const QStringList parts = m_state.hint().split(QStringLiteral(" · "));
        m_note->setText(parts.join(QStringLiteral("\n\n")));
    }
}

} // namespace crowd::widgets

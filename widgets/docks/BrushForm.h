// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <QtWidgets/QVBoxLayout>
#include <QtWidgets/QWidget>

#include "model/brush/BrushSettings.h"
#include "widgets/docks/ValueSlider.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// Puts controls bound to one brush's settings one below the other. Every control reads its value
/// through a refresher and writes through EditorState::setBrush. A row can be shown only when
/// the settings make it matter.
class BrushForm : public QWidget
{
    Q_OBJECT

public:
    using Settings = model::BrushSettings;
    using Condition = std::function<bool(const Settings&)>;

    BrushForm(EditorState& state, model::BrushKind kind, QWidget* parent);

    void addTitle(const QString& text);
    void addSlider(const QString& label, const ValueSlider::Range& range,
                   std::function<double(const Settings&)> get,
                   std::function<void(Settings&, double)> set, Condition isShown = {});
    void addChoice(const QString& label, const QStringList& names,
                   std::function<int(const Settings&)> get, std::function<void(Settings&, int)> set,
                   Condition isShown = {});
    void addCheck(const QString& label, const QString& tip,
                  std::function<bool(const Settings&)> get,
                  std::function<void(Settings&, bool)> set, Condition isShown = {});
    /// Numbers separated by commas or ranges "1, 3-5"; empty: all.
    void addNumberList(const QString& label, const QString& tip,
                       std::function<std::vector<int>(const Settings&)> get,
                       std::function<void(Settings&, std::vector<int>)> set,
                       Condition isShown = {});
    void addCurve(std::function<model::DistributionCurve(const Settings&)> get,
                  std::function<void(Settings&, const model::DistributionCurve&)> set,
                  Condition isShown);
    /// Clips of the scene's templates with a tick each.
    void addClips(std::function<std::vector<model::ClipWeight>(const Settings&)> get,
                  std::function<void(Settings&, std::vector<model::ClipWeight>)> set);
    void finish();
    void refresh();

private:
    void bind(QWidget* row, std::function<void(const Settings&)> refresh, Condition isShown);
    template<class Change>
    void change(const Change& apply);

    EditorState& m_state;
    model::BrushKind m_kind;
    QVBoxLayout* m_layout;
    std::vector<std::function<void(const Settings&)>> m_refreshers;
    bool m_isRefreshing = false;
};

/// Fills a form with everything that a brush of its kind can be set to.
void fillBrushForm(BrushForm& form, model::BrushKind kind, const EditorState& state);

} // namespace crowd::widgets

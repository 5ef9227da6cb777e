// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QVBoxLayout>
#include <QtWidgets/QWidget>

#include "model/brush/BrushSettings.h"
#include "widgets/docks/ValueSlider.h"
#include "widgets/state/EditorState.h"

class QToolButton;

namespace crowd::widgets {

/// Clips that a form lets choose from: all, or those that people can walk with.
enum class ClipsOnOffer { All, Moving };

/// Puts controls bound to one brush's settings one below the other. Every control reads its value
/// through a refresher and writes through EditorState::setBrush. A row can be shown only when
/// the settings make it matter; sections fold, and stay folded in later sessions.
class BrushForm : public QWidget
{
    Q_OBJECT

public:
    using Settings = model::BrushSettings;
    using Condition = std::function<bool(const Settings&)>;

    BrushForm(EditorState& state, model::BrushKind kind, QWidget* parent);

    /// What is added from here on folds under the title. `key` names it in the settings.
    void beginSection(const QString& title, const QString& key);
    /// What is added until endRow() stands side by side.
    void beginRow();
    void endRow() { m_row = nullptr; }

    void addSlider(const QString& label, const ValueSlider::Range& range,
                   std::function<double(const Settings&)> get,
                   std::function<void(Settings&, double)> set, Condition isShown = {});
    void addRange(const QString& label, const ValueSlider::Range& range,
                  std::function<model::ValueRange&(Settings&)> value, Condition isShown = {});
    void addChoice(const QString& label, const QStringList& names,
                   std::function<int(const Settings&)> get, std::function<void(Settings&, int)> set,
                   Condition isShown = {});
    void addCheck(const QString& label, const QString& tip,
                  std::function<bool(const Settings&)> get,
                  std::function<void(Settings&, bool)> set, Condition isShown = {});
    void addColour(const QString& label, std::function<model::PaintColor(const Settings&)> get,
                   std::function<void(Settings&, const model::PaintColor&)> set);
    /// A colour and a text beside it, to be looked at only.
    void addSwatch(std::function<QColor(const Settings&)> color,
                   std::function<QString(const Settings&)> text);
    void addText(const QString& label, std::function<QString(const Settings&)> get,
                 std::function<void(Settings&, const QString&)> set);
    struct NumberList
    {
        QString label;
        QString tip;
        std::function<std::vector<int>&(Settings&)> numbers;
    };
    /// Side by side; numbers separated by commas or ranges "1, 3-5"; empty: all.
    void addNumberLists(const std::vector<NumberList>& lists, const Condition& isShown);
    void addCurve(std::function<model::DistributionCurve(const Settings&)> get,
                  std::function<void(Settings&, const model::DistributionCurve&)> set,
                  Condition isShown = {});
    /// Clips of the scene's templates with a tick and a weight each.
    void addClips(std::function<std::vector<model::ClipWeight>&(Settings&)> clips,
                  ClipsOnOffer offer = ClipsOnOffer::All);
    void addButton(const QString& label, const QString& tip, std::function<void()> run,
                   Condition isShown = {});
    void addText(const QString& label, std::function<std::string(const Settings&)> get,
                 std::function<void(Settings&, const std::string&)> set);
    void addLabel(const QString& text, Condition isShown = {});
    void addNote(const QString& text, Condition isShown = {});
    void finish();
    void refresh();

private:
    struct Section
    {
        QToolButton* header;
        QString key;
        bool isOpen = true;
    };
    struct Row
    {
        QWidget* widget;
        std::function<void(const Settings&)> refresh;
        Condition isShown;
        int section; ///< -1: none
    };
    void bind(QWidget* row, std::function<void(const Settings&)> refresh, Condition isShown);
    void fold(int section, bool isOpen);
    void refreshVisibility();
    template<class Change>
    void change(const Change& apply);

    EditorState& m_state;
    model::BrushKind m_kind;
    QVBoxLayout* m_layout;
    QHBoxLayout* m_row = nullptr;   ///< being filled
    std::vector<QWidget*> m_groups; ///< rows of several controls
    std::vector<Section> m_sections;
    std::vector<Row> m_rows;
    bool m_isRefreshing = false;
};

/// Fills a form with everything that a brush of its kind can be set to.
void fillBrushForm(BrushForm& form, model::BrushKind kind, EditorState& state);

/// The part of it for the settings that the chosen script brush brings along.
void addScriptSettings(BrushForm& form, EditorState& state);

} // namespace crowd::widgets

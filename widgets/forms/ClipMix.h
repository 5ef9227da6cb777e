// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QtWidgets/QWidget>

#include "model/brush/BrushSettings.h"

class QCheckBox;
class QGridLayout;

namespace crowd::widgets {

class ValueSlider;

/// Clips, or other things that go by names, to choose among, with a tick each and a weight for
/// those that are ticked. Several sections have their titles above them.
class ClipMix : public QWidget
{
    Q_OBJECT

public:
    /// What stands for a name on screen.
    using Texts = std::function<QString(const std::string& name)>;

    struct Section
    {
        QString title;
        std::vector<std::string> names;
    };

    ClipMix(const std::vector<std::string>& names, QWidget* parent, const Texts& texts = {});
    ClipMix(const std::vector<Section>& sections, QWidget* parent, const Texts& texts = {});

    /// Without signal. `areWeighed`: their weights count.
    void setClips(const std::vector<model::ClipWeight>& clips, bool areWeighed = true);

Q_SIGNALS:
    /// Weight 0: not ticked any more.
    void edited(const crowd::model::ClipWeight& clip);
    /// The mouse is on its name, which is there on the screen.
    void pointedAt(const std::string& name, const QRect& place);
    /// The mouse is on no name any more.
    void left();

protected:
    bool eventFilter(QObject* tick, QEvent* event) override;

private:
    void addRow(QGridLayout& grid, const std::string& name, const QString& text);

    struct Row
    {
        std::string name;
        QCheckBox* tick;
        ValueSlider* weight;
    };
    std::vector<Row> m_rows;
};

} // namespace crowd::widgets

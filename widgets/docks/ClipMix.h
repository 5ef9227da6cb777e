// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QtWidgets/QWidget>

#include "model/brush/BrushSettings.h"

class QCheckBox;

namespace crowd::widgets {

class ValueSlider;

/// Clips, or other things that go by names, to choose among, with a tick each and a weight for
/// those that are ticked.
class ClipMix : public QWidget
{
    Q_OBJECT

public:
    /// What stands for a name on screen.
    using Texts = std::function<QString(const std::string& name)>;

    ClipMix(const std::vector<std::string>& names, QWidget* parent, const Texts& texts = {});

    /// Without signal. `areWeighed`: their weights count.
    void setClips(const std::vector<model::ClipWeight>& clips, bool areWeighed = true);

Q_SIGNALS:
    /// Weight 0: not ticked any more.
    void edited(const crowd::model::ClipWeight& clip);

private:
    struct Row
    {
        std::string name;
        QCheckBox* tick;
        ValueSlider* weight;
    };
    std::vector<Row> m_rows;
};

} // namespace crowd::widgets

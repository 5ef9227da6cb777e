// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QtCore/QObject>
#include <QtCore/QString>

#include "app/record/StrokeScript.h"
#include "model/base/Result.h"
#include "model/document/SceneDocument.h"

namespace crowd::app {

/// Writes down what is done to the document as Python that does it again: from the scene as it was
/// at the start to the same bytes. Strokes are written as strokes, everything else by id; where a
/// stroke could not be repeated exactly, what came of it. Ends with its scene. Main thread; the
/// document outlives it.
class Recorder : public QObject
{
    Q_OBJECT

public:
    explicit Recorder(model::SceneDocument& document, QObject* parent = nullptr);
    ~Recorder() override;

    [[nodiscard]] bool isRecording() const { return m_isRecording; }
    /// Starting begins a new script.
    void setRecording(bool isOn);
    [[nodiscard]] bool isEmpty() const { return m_steps.empty(); }
    /// All of it. With a name it opens the scene of that name beside itself, else the one that the
    /// document was at the start.
    [[nodiscard]] std::string script(const QString& startName = {}) const;
    /// As PATH, with the scene as it was at the start beside it: NAME-start.crowd.
    [[nodiscard]] model::Result<void> save(const QString& path) const;

Q_SIGNALS:
    void recordingChanged(bool isOn);
    void started(); ///< anew: what was there is gone
    void added(const QString& text);
    /// For the status bar.
    void remarked(const QString& text);

private:
    void commit(const model::StepCommitted& step);
    void takeStep(bool isUndo);
    void followScene(const model::SceneChange& change);
    void begin();
    void add(std::string text);
    [[nodiscard]] bool startsEmpty() const;

    model::SceneDocument& m_document;
    bool m_isRecording = false;
    std::unique_ptr<const model::Scene> m_start; ///< columns are shared
    QString m_startPath;
    StrokeScript m_strokes;
    std::vector<std::string> m_steps;
    // Undo steps [m_first, m_end) are the script's own; it stands behind m_index of them.
    int m_first = 0;
    int m_end = 0;
    int m_index = 0;
};

} // namespace crowd::app

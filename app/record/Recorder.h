// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
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
/// stroke could not be repeated exactly, even with whom it selected, what came of it. Ends with its
/// scene. Main thread; the document outlives it.
class Recorder : public QObject
{
    Q_OBJECT

public:
    /// Whether a stroke that met people elsewhere comes to the same when whom it meant is said.
    using Proof = std::function<bool(const model::StepCommitted&)>;

    explicit Recorder(model::SceneDocument& document, QObject* parent = nullptr);
    ~Recorder() override;

    /// Empty: such strokes are written as what came of them.
    void setProof(Proof proof) { m_proof = std::move(proof); }

    [[nodiscard]] bool isRecording() const { return m_isRecording; }
    /// Starting begins a new script.
    void setRecording(bool isOn);
    [[nodiscard]] bool isEmpty() const { return m_script.steps.empty(); }
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
    void bringBack();
    void add(std::string text);
    void addStroke(const model::StepCommitted& step);
    [[nodiscard]] bool startsEmpty() const;

    struct Script
    {
        std::unique_ptr<const model::Scene> start; ///< columns are shared
        QString startPath;
        StrokeScript strokes;
        std::vector<std::string> steps;
        // Undo steps [first, end) are the script's own.
        int first = 0;
        int end = 0;
    };
    /// One that began anew because a step was taken that it does not know.
    struct LeftScript
    {
        Script script;
        int index = 0; ///< of the undo stack, where it was left
    };

    model::SceneDocument& m_document;
    Proof m_proof;
    bool m_isRecording = false;
    Script m_script;
    int m_index = 0;                  ///< of the undo stack
    std::optional<LeftScript> m_left; ///< comes back at its index, unless something else is done
};

} // namespace crowd::app

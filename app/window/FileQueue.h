// SPDX-License-Identifier: MIT
#pragma once

#include <deque>

#include <QtCore/QObject>
#include <QtCore/QStringList>
#include <QtCore/QTimer>

namespace crowd::app {

class AssetController;
class FileController;

/// Several files at once, from the command line or dropped on the window: one scene for this
/// window, windows of their own for further scenes, models one after the other.
class FileQueue : public QObject
{
    Q_OBJECT

public:
    FileQueue(FileController& files, AssetController& assets, QObject* parent);

    /// What the window starts with: what a crash left, else the files, else the theatre. Models
    /// without a scene come to empty ground.
    void openAtStart(const QStringList& files);
    /// Asks of each model what it is to be.
    void drop(const QStringList& files);
    [[nodiscard]] bool isEmpty() const { return m_models.empty(); }

private:
    struct Model
    {
        QString path;
        bool asks;
    };

    void add(const QStringList& models, bool asks);
    void next();

    FileController& m_files;
    AssetController& m_assets;
    std::deque<Model> m_models;
    int m_brought = 0; ///< of those that came together
    QTimer m_timer;    ///< looks whether the window is free for the next
};

} // namespace crowd::app

// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QStringList>

namespace crowd::app {

/// Runs the editor: opens a scene and brings in models; without files the ready-made theatre.
/// The language is a code, "de", for this time; empty: the remembered one. Returns the exit status;
/// 1 with a message when there is no display.
int runEditor(int& argc, char** argv, const QStringList& files, const QString& language);

} // namespace crowd::app

// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include <QtCore/QString>

#include "behavior/session/MotionCache.h"
#include "model/base/Message.h"
#include "model/base/Result.h"
#include "model/scene/Take.h"

/// Takes as files: the steps of a run as its cache has them, piece by piece, and behind them what
/// the steps are besides. With checksums; of machines of one byte order.
namespace crowd::behavior {

/// Told how much is done, 0..1; false: it is given up.
using TakeProgress = std::function<bool(double share)>;

/// Writes what a cache has of a run into a folder, which is made where there is none. The file is
/// called after what is in it, so that one that is there already is the same. The take has no id
/// and no name yet. Any thread, also while the run goes on.
[[nodiscard]] model::Result<model::Take> writeTake(const MotionCache& run, const QString& folder,
                                                   const TakeProgress& progress = {});

/// A take's steps, for MotionReader. Reads what the file says of them; they are read when they are
/// asked for.
[[nodiscard]] model::Result<std::shared_ptr<MotionCache>>
openTake(const model::MotionFilePtr& file);

/// What is said of one whose steps cannot be read.
[[nodiscard]] model::Message damagedTake();

} // namespace crowd::behavior

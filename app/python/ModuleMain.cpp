// SPDX-License-Identifier: MIT
#include <dlfcn.h>

#include <pybind11/pybind11.h>

#include <QtCore/QFileInfo>
#include <QtCore/QString>

#include "app/python/PythonModule.h"
#include "model/project/AssetPaths.h"

/// The module for a plain python3: built-in content is looked for from where the module lies.
PYBIND11_MODULE(crowdbrush, module)
{
    Dl_info where{};
    if (dladdr(reinterpret_cast<void*>(&crowd::app::registerModule), &where) != 0) {
        const QFileInfo file(QString::fromLocal8Bit(where.dli_fname));
        crowd::model::setProgramFolder(file.canonicalPath());
    }
    crowd::app::registerModule(module);
}

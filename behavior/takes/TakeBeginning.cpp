// SPDX-License-Identifier: MIT
#include "behavior/takes/TakeBeginning.h"

#include <memory>
#include <utility>

#include "behavior/takes/EditedTake.h"
#include "behavior/takes/TakeFile.h"

namespace crowd::behavior {

model::Result<RunBeginning> beginningIn(const model::Take& take, const model::Scene& scene,
                                        double seconds)
{
    auto opened = EditedTake::open(take, scene);
    if (!opened) {
        return opened.error();
    }
    const std::shared_ptr<EditedTake> edited = std::move(opened).value();
    auto beginning = beginningIn([edited](double at) { return edited->around(at); },
                                 edited->motion()->extent().first, seconds);
    if (!beginning) {
        return model::Error{damagedTake()};
    }
    return std::move(*beginning);
}

} // namespace crowd::behavior

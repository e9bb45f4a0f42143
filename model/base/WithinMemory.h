// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"

#include <QCoreApplication>

#include <new>
#include <type_traits>

namespace espalier {

/// The error of work for which there is not enough memory.
inline Error memoryError()
{
    return {Error::Kind::Output,
            QCoreApplication::translate("WithinMemory", "There is not enough memory for this.")};
}

/// Returns work(). If there is not enough memory and the result can be an Error, that is the result; all that
/// the work has made is gone then.
template <class Work>
auto withinMemory(Work& work) -> decltype(work())
{
    if constexpr (std::is_convertible_v<Error, decltype(work())>) {
        try {
            return work();
        } catch (const std::bad_alloc&) {
            return memoryError();
        }
    } else {
        return work();
    }
}

} // namespace espalier

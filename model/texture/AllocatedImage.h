// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include <new>
#include <utility>

namespace espalier {

/// @p image, or std::bad_alloc if it is null: Qt gives a null image where memory is short, and the next line
/// would write into it.
inline QImage allocated(QImage image)
{
    if (image.isNull())
        throw std::bad_alloc();
    return image;
}

} // namespace espalier

# SPDX-License-Identifier: BSD-3-Clause

# The sets of precompiled headers (see precompile.cmake). None contains CLI11, whose definitions
# would be compiled into every source.
#
# Modules are also linked into the Python package, a shared library: position-independent, and nothing
# of them is visible to others, so that calls within a module are as direct as in a program.
set(module_options -fPIC -fvisibility=hidden -fvisibility-inlines-hidden)
# The window waits for people and for the modules: its own code is optimized less.
set(window_options -O1)
set(standard
  algorithm array atomic bit charconv chrono cmath cstdint filesystem fstream functional limits map memory
  optional span sstream stdexcept string string_view utility variant vector)
set(eigen Eigen/Cholesky Eigen/Core Eigen/Geometry)

perilymph_precompiled_headers(engine
  LINKS Eigen3::Eigen OPTIONS ${module_options} HEADERS ${standard} ${eigen})
perilymph_precompiled_headers(documents
  LINKS Eigen3::Eigen nlohmann_json::nlohmann_json OPTIONS ${module_options} HEADERS ${standard} ${eigen} nlohmann/json.hpp)
if(PERILYMPH_TESTS)
  # What takes time in a test is in the modules; the test itself is optimized less, which compiles faster.
  set(gtest gmock/gmock.h gtest/gtest.h)
  perilymph_precompiled_headers(tests
    LINKS Eigen3::Eigen GTest::gmock GTest::gtest OPTIONS -O1 HEADERS ${standard} ${eigen} ${gtest})
endif()
if(PERILYMPH_WINDOW AND PERILYMPH_TOOLKIT)
  set(widgets
    QCoreApplication QElapsedTimer QEvent QFont QFontMetrics QFrame QGridLayout QHBoxLayout QKeyEvent QLabel
    QMouseEvent QObject QPainter QPainterPath QPixmap QPushButton QString QStringList QStyle QTimer
    QVBoxLayout QVariant QWidget)
  perilymph_precompiled_headers(window
    LINKS Eigen3::Eigen ${PERILYMPH_QT}::Widgets
    DEFINITIONS QT_NO_KEYWORDS
    OPTIONS ${window_options}
    HEADERS ${standard} ${eigen} ${widgets})
  if(PERILYMPH_TESTS)
    perilymph_precompiled_headers(window_tests
      LINKS Eigen3::Eigen ${PERILYMPH_QT}::Widgets ${PERILYMPH_QT}::Test GTest::gmock GTest::gtest
      DEFINITIONS QT_NO_KEYWORDS
      OPTIONS ${window_options}
      HEADERS ${standard} ${eigen} ${widgets} QTest ${gtest})
  endif()
endif()

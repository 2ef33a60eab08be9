#include "BadHeader.h"

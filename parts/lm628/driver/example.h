/* SPDX-License-Identifier: Apache-2.0 */
#ifndef LM628_EXAMPLE_H
#define LM628_EXAMPLE_H

#include "lm628.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Moves to `target` [count] and tells where the shaft then is. */
lm628_error lm628_example_move(const lm628_port *port, int32_t target, int32_t *reached);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: Apache-2.0
 *
 * The host port of an LM628 at two addresses of memory, where the hardware keeps the data sheet's
 * times: as behind a bus bridge, or with PS on an address line.
 */
#ifndef LM628_MMIO_H
#define LM628_MMIO_H

#include "lm628.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct lm628_mmio {
  uintptr_t command; /* PS low: a write is a command, a read the status */
  uintptr_t data;    /* PS high */
  uintptr_t reset;   /* a write strobes RST */
  bool has_reset;
  uint8_t bits;      /* of an access: 8, 16 or 32; addresses are multiples of it */
  void (*wait_us)(void *context, uint32_t us);
  /* For a bus that no pointer reaches; both NULL: volatile accesses. */
  uint32_t (*load)(void *context, uintptr_t address);
  void (*store)(void *context, uintptr_t address, uint32_t value);
  void *context;
} lm628_mmio;

/* Fills in `port`; `mmio` stays in use. Accesses nothing. LM628_ERROR_NULL, and LM628_ERROR_RANGE
 * of a width or address. */
lm628_error lm628_mmio_port(lm628_port *port, lm628_mmio *mmio);

#ifdef __cplusplus
}
#endif

#endif

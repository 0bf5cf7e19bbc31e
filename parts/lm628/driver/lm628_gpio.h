/* SPDX-License-Identifier: Apache-2.0
 *
 * The host port of an LM628 on general-purpose pins: five control lines and a bus of 8 bits, with
 * the times of the data sheet (SNVS781C p.4) as waits of `wait_ns`.
 */
#ifndef LM628_GPIO_H
#define LM628_GPIO_H

#include "lm628.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Levels of the pins: a 1 is high. CS, RD, WR and RST are active low. */
enum lm628_gpio_line {
  LM628_GPIO_CS = 0x01,
  LM628_GPIO_RD = 0x02,
  LM628_GPIO_WR = 0x04,
  LM628_GPIO_PS = 0x08,
  LM628_GPIO_RST = 0x10
};

typedef struct lm628_gpio {
  void (*set_lines)(void *context, uint8_t levels); /* all five */
  void (*drive_bus)(void *context, uint8_t byte);   /* makes it an output */
  void (*release_bus)(void *context);               /* makes it an input */
  uint8_t (*read_bus)(void *context);
  void (*wait_ns)(void *context, uint32_t ns); /* at least so long; asked for at most 1,500,000 */
  bool has_reset;                              /* RST is wired */
  void *context;
} lm628_gpio;

/* Fills in `port` and puts the lines to rest; `gpio` stays in use. LM628_ERROR_NULL. */
lm628_error lm628_gpio_port(lm628_port *port, lm628_gpio *gpio);

#ifdef __cplusplus
}
#endif

#endif

trammel_with_part(lm628)
